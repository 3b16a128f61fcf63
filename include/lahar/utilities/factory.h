// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_factory_h
#define lahar_utilities_factory_h

#include <lahar/utilities/parameters.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Lahar
{
  using namespace dealii;

  /// Names under which a second model of the same kind came, and was not taken; see load_plugins().
  std::vector<std::string> &doubled_model_names();

  /**
   * The models of one kind, by name.
   *
   * A model registers itself at the end of its .cc file, in Lahar or in a plugin, with a static object of type
   * Registration, under a name of its own and with a sentence that says what it is:
   * @code
   *   static const Factory<FluidLaw>::Registration<Bingham> bingham("Bingham", "Plastic viscosity, yield stress.");
   * @endcode
   * @p Base needs `void parse_parameters(Parameters &)`, every model a static
   * `void declare_parameters(Parameters &)`. Each model's entries stand in a subsection of the model's name.
   */
  template <typename Base>
  class Factory
  {
  public:
    template <typename Model>
    struct Registration
    {
      Registration(const std::string &name, const std::string &description)
      {
        const Entry entry{[]() { return std::make_unique<Model>(); }, &Model::declare_parameters,
                          description};
        if (!models().emplace(name, entry).second)
          doubled_model_names().push_back(name);
      }
    };

    /// The names of all models, separated by '|' as Patterns::Selection wants them.
    static std::string names()
    {
      std::string list;
      for (const auto &[name, model] : models())
        list += (list.empty() ? "" : "|") + name;
      return list;
    }

    /// "name: description" of all models, one after the other.
    static std::string descriptions()
    {
      std::string text;
      for (const auto &[name, model] : models())
        text += (text.empty() ? "'" : " '") + name + "': " + model.description;
      return text;
    }

    static bool contains(const std::string &name)
    {
      return models().count(name) > 0;
    }

    /// Declare one subsection per model in the handler's current section.
    static void declare_parameters(Parameters &prm)
    {
      for (const auto &[name, model] : models())
      {
        prm.enter_subsection(name);
        model.declare(prm);
        prm.leave_subsection();
      }
    }

    /// Create the model @p name, which the factory must contain, and let it read its subsection of the handler's
    /// current section.
    static std::unique_ptr<Base> create(const std::string &name, Parameters &prm)
    {
      const auto entry = models().find(name);
      Assert(entry != models().end(), ExcMessage("There is no model '" + name + "'."));
      std::unique_ptr<Base> model = entry->second.create();
      prm.enter_subsection(name);
      model->parse_parameters(prm);
      prm.leave_subsection();
      return model;
    }

    /// Declare the entry @p entry, which chooses a model by its name, and one subsection per model. An empty
    /// @p default_name makes the user choose. @param documentation what the choice is about.
    static void declare_choice(Parameters &prm, const std::string &entry, const std::string &default_name,
                               const std::string &documentation)
    {
      prm.declare_choice(entry, default_name, names(),
                         documentation + " " + descriptions() +
                           " Its parameters, if it has any, stand in the subsection of its name.");
      declare_parameters(prm);
    }

    /// Create the model that @p entry of the handler's current section names. @throws InputError if there is none.
    static std::unique_ptr<Base> create_chosen(Parameters &prm, const std::string &entry)
    {
      if (!contains(prm.get(entry)))
        prm.throw_wrong_value(entry, names());
      return create(prm.get(entry), prm);
    }

  private:
    struct Entry
    {
      std::function<std::unique_ptr<Base>()> create;
      std::function<void(Parameters &)> declare;
      std::string description;
    };

    static std::map<std::string, Entry> &models()
    {
      static std::map<std::string, Entry> registered;
      return registered;
    }
  };
} // namespace Lahar

#endif
