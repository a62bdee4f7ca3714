// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/version.hpp"

namespace interphase {

std::string description(const Version& version)
{
    std::string text = name_and_number(version) + ", commit " + version.commit;
    if (version.uncommitted_changes == "yes") text += " with uncommitted changes";
    return text + "\nbuilt by " + version.compiler + ", " + version.build_type + ": " + version.flags + "\n";
}

}  // namespace interphase
