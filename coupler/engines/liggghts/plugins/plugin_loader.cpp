// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/liggghts/plugins/plugin_loader.hpp"

#include <cxxabi.h>
#include <dlfcn.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <optional>

#include "base/sha256.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "engines/liggghts/plugins/fix_registration.hpp"
#include "engines/liggghts/plugins/plugin_fit.hpp"
#include "engines/liggghts/plugins/plugin_search.hpp"
#include "lammps.h"

namespace interphase {

namespace {

/// Names of our own fixes begin so.
constexpr const char* own_prefix = "interphase/";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The words of the dynamic linker, with the symbol that is missing as it stands in the source.
std::string readable(const std::string& words)
{
    const std::string before = "undefined symbol: ";
    const std::size_t at = words.find(before);
    if (at == std::string::npos) return words;
    const std::size_t start = at + before.size();
    const std::string symbol = words.substr(start, words.find_first_of(", \n", start) - start);
    int failed = 0;
    const std::unique_ptr<char, void (*)(void*)> plain(abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &failed),
                                                       std::free);
    return plain ? words + " = " + plain.get() : words;
}

std::string remedy_for(const std::string& words)
{
    if (contains(words, "undefined symbol"))
        return "define it in the plug-in or link the library that has it; if LIGGGHTS or a compiler should have it, "
               "the "
               "plug-in was built against another one: build it anew";
    if (contains(words, "cannot open shared object file"))
        return "install the library that it names, or put its folder into LD_LIBRARY_PATH";
    return "give a shared library for this machine, as interphase_add_plugin (CMake) builds one";
}

class Loading {
public:
    Loading(LAMMPS_NS::LAMMPS& lmp, const std::string& asked_by) : modify_(*lmp.modify), asked_by_(asked_by) {}

    /// Opens and checks; LIGGGHTS knows nothing of it yet.
    void prepare(const std::string& wanted)
    {
        const std::string file = find_plugin(wanted, asked_by_);
        const PluginDescriptor& plugin = descriptor_in(file);
        if (const auto misfit = misfit_of(plugin))
            throw UserError("the plug-in " + file + " " + misfit->what, asked_by_, misfit->remedy);
        if (!plugin.name || !*plugin.name || !plugin.styles || plugin.style_count == 0)
            throw UserError("the plug-in " + file + " has no name or brings no fix style", asked_by_,
                            "give INTERPHASE_PLUGIN a name and at least one style");
        std::ifstream library(file, std::ios::binary);
        LoadedPlugin loaded{plugin.name, file, sha256(library), {}};
        for (std::uint64_t i = 0; i < plugin.style_count; ++i) {
            take(plugin.styles[i], loaded);
            loaded.styles.emplace_back(plugin.styles[i].name);
        }
        plugins_.push_back(loaded);
    }

    std::vector<LoadedPlugin> finish()
    {
        for (const auto& [name, owned] : styles_)
            register_fix_style(modify_, name, owned.create);
        return plugins_;
    }

private:
    struct Owned {
        std::string by;
        FixCreator create;
    };

    const PluginDescriptor& descriptor_in(const std::string& file)
    {
        // It is never closed: its fixes live as long as LIGGGHTS, its code as long as they may.
        void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!library) {
            std::string words = dlerror();
            if (words.rfind(file + ": ", 0) == 0) words.erase(0, file.size() + 2);
            throw UserError("the plug-in " + file + " cannot be loaded: " + readable(words), asked_by_,
                            remedy_for(words));
        }
        const auto [other, is_new] = files_.emplace(library, file);
        if (!is_new)
            throw UserError("the plug-in " + file + " is given twice" +
                                (other->second == file ? "" : " (it is the same as " + other->second + ")"),
                            asked_by_, "name it once");
        const auto entry = reinterpret_cast<PluginEntryPoint>(dlsym(library, plugin_entry_point));
        const PluginDescriptor* plugin = entry ? entry() : nullptr;
        if (!plugin)
            throw UserError("the library " + file + " is no plug-in of interphase: it has no function " +
                                plugin_entry_point + " that describes one",
                            asked_by_, "add INTERPHASE_PLUGIN(...) to one of its sources (plugins/README.md)");
        return *plugin;
    }

    void take(const PluginStyle& style, const LoadedPlugin& plugin)
    {
        const std::string name = style.name ? style.name : "";
        bool usable = !name.empty() && style.create;
        for (const unsigned char c : name)
            usable = usable && std::isgraph(c);
        if (!usable)
            throw UserError("the plug-in " + plugin.file + " brings the fix style `" + name +
                                "`, which no script could name or nothing creates",
                            asked_by_, "name it in letters, digits, `_` and `/`, with a function that creates it");
        const std::string of_plugin =
            "the fix style `" + name + "` of the plug-in " + plugin.name + " (" + plugin.file + ")";
        if (name.rfind(own_prefix, 0) == 0)
            throw UserError(of_plugin + " begins with `" + own_prefix + "`, which is kept for the coupler", asked_by_,
                            "give it another name");
        if (knows_fix_style(modify_, name))
            throw UserError(of_plugin + " is one of LIGGGHTS's own styles already", asked_by_, "give it another name");
        const auto [other, is_new] = styles_.emplace(name, Owned{plugin.name + " (" + plugin.file + ")", style.create});
        if (!is_new)
            throw UserError(of_plugin + " is brought by the plug-in " + other->second.by + " already", asked_by_,
                            "leave one of the two plug-ins away, or rename the style in one");
    }

    LAMMPS_NS::Modify& modify_;
    const std::string& asked_by_;
    std::map<void*, std::string> files_;
    std::map<std::string, Owned> styles_;
    std::vector<LoadedPlugin> plugins_;
};

/// Ranks may run on machines whose disks differ.
std::string this_rank(const Communicator& comm)
{
    if (comm.is_master()) return "";
    char host[256] = "";
    gethostname(host, sizeof host - 1);
    return ", on rank " + std::to_string(comm.rank()) + " (" + host + ")";
}

}  // namespace

std::string described(const std::vector<LoadedPlugin>& plugins)
{
    std::string all;
    for (const LoadedPlugin& plugin : plugins)
        all += (all.empty() ? "" : ", ") + plugin.name + " (" + plugin.file + ": " + listed(plugin.styles) + ")";
    return all.empty() ? "none" : all;
}

std::vector<LoadedPlugin> load_plugins(const Communicator& comm, LAMMPS_NS::LAMMPS& lmp,
                                       const std::vector<std::string>& wanted, const std::string& asked_by)
{
    const std::string place = asked_by + this_rank(comm);
    Loading loading(lmp, place);
    std::optional<Problem> problem;
    try {
        for (const std::string& name : wanted)
            loading.prepare(name);
    } catch (const UserError& error) {
        problem = error.problem();
    }
    comm.fail_together(problem);
    return loading.finish();
}

}  // namespace interphase
