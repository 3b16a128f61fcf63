// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef lahar_utilities_factory_h
#define lahar_utilities_factory_h

#include <lahar/utilities/parameters.h>

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <type_traits>
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
   * @p Base needs a virtual `void parse_parameters(Parameters &)`. A model with entries has a static
   * `void declare_parameters(Parameters &)`; they stand in a subsection of the model's name or of the one that its
   * registration gives. A model that has no such function, or only that of @p Base, which is about the whole kind, has
   * no entries: no subsection, and parse_parameters() is not called.
   */
  template <typename Base>
  class Factory
  {
  public:
    template <typename Model>
    struct Registration
    {
      /// @param section where the model's entries stand, if not in the subsection of its name.
      Registration(const std::string &name, const std::string &description, const std::string &section = "")
      {
        const Entry entry{[]() { return std::make_unique<Model>(); }, declaration<Model>(), description,
                          section.empty() ? name : section};
        if (!models().emplace(name, entry).second)
          doubled_model_names().push_back(name);
      }
    };

    /// Names of models.
    using Names = std::set<std::string>;

    /// The names of all models but @p except, separated by '|' as Patterns::Selection wants them.
    static std::string names(const Names &except = {})
    {
      std::string list;
      for (const auto &[name, model] : models())
        if (except.count(name) == 0)
          list += (list.empty() ? "" : "|") + name;
      return list;
    }

    /// "name: description" of all models but @p except, one after the other.
    static std::string descriptions(const Names &except = {})
    {
      std::string text;
      for (const auto &[name, model] : models())
        if (except.count(name) == 0)
          text += (text.empty() ? "'" : " '") + name + "': " + model.description;
      return text;
    }

    static bool contains(const std::string &name)
    {
      return models().count(name) > 0;
    }

    /// Declare an entry whose value is the name of a model. @param documentation what is chosen; what the models are
    /// follows. @param except cannot be chosen.
    static void declare_choice(Parameters &prm, const std::string &entry, const std::string &default_name,
                               const std::string &documentation, const Names &except = {})
    {
      prm.declare_choice(entry, default_name, names(except), documentation + " " + descriptions(except));
    }

    /// The value of such an entry. @throws InputError with the names of all models if it is none of them.
    static std::string choice(const Parameters &prm, const std::string &entry, const Names &except = {})
    {
      const std::string name = prm.get(entry);
      if (!contains(name) || except.count(name) > 0)
        prm.throw_wrong_value(entry, names(except));
      return name;
    }

    /// Declare one subsection for each model with entries, but @p except, in the handler's current section.
    static void declare_parameters(Parameters &prm, const Names &except = {})
    {
      for (const auto &[name, model] : models())
        if (model.declare && except.count(name) == 0)
        {
          prm.enter_subsection(model.section);
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
      if (entry->second.declare)
      {
        prm.enter_subsection(entry->second.section);
        model->parse_parameters(prm);
        prm.leave_subsection();
      }
      return model;
    }

    /// Declare such an entry and the models' subsections. An empty @p default_name makes the user choose.
    static void declare_models(Parameters &prm, const std::string &entry, const std::string &default_name,
                               const std::string &documentation, const Names &except = {})
    {
      declare_choice(prm, entry, default_name,
                     documentation + " Its parameters, if it has any, stand in the subsection of its name.",
                     except);
      declare_parameters(prm, except);
    }

    /// Create the model that @p entry of the handler's current section names. @throws InputError if there is none.
    static std::unique_ptr<Base> create_chosen(Parameters &prm, const std::string &entry,
                                               const Names &except = {})
    {
      return create(choice(prm, entry, except), prm);
    }

  private:
    using Declaration = void (*)(Parameters &);

    struct Entry
    {
      std::function<std::unique_ptr<Base>()> create;
      Declaration declare; ///< null for a model without entries
      std::string description, section;
    };

    template <typename T, typename = void>
    struct Declares : std::false_type
    {};

    template <typename T>
    struct Declares<T, std::void_t<decltype(static_cast<Declaration>(&T::declare_parameters))>>
      : std::true_type
    {};

    /// The model's own function, or one that it inherits from another model; not that of @p Base.
    template <typename Model>
    static Declaration declaration()
    {
      Declaration own = nullptr, of_kind = nullptr;
      if constexpr (Declares<Model>::value)
        own = &Model::declare_parameters;
      if constexpr (Declares<Base>::value)
        of_kind = &Base::declare_parameters;
      return own == of_kind ? nullptr : own;
    }

    static std::map<std::string, Entry> &models()
    {
      static std::map<std::string, Entry> registered;
      return registered;
    }
  };
} // namespace Lahar

#endif
