#ifndef lahar_utilities_checkpoint_file_h
#define lahar_utilities_checkpoint_file_h

#include <string>

namespace Lahar
{
  /**
   * The file `checkpoint/state` in an output directory: a text header with the format's version and the length and
   * CRC-32 checksum of the binary data that follow.
   */
  class CheckpointFile
  {
  public:
    /// Raised whenever the data mean something else.
    static constexpr unsigned int format_version = 2;

    explicit CheckpointFile(const std::string &output_directory);

    /// Replace the file, which is never there in part. @throws RunError
    void write(const std::string &data) const;

    /// @return the data. @throws InputError if the file is missing, truncated, corrupted or of another format.
    std::string read() const;

    /// Remove the file if there is one. @throws RunError
    void remove() const;

    /// @throws InputError that names the file, what was @p found and what is @p allowed.
    [[noreturn]] void fail(const std::string &found, const std::string &allowed) const;

  private:
    std::string directory, file_name;
  };
} // namespace Lahar

#endif
