# SPDX-License-Identifier: GPL-3.0-or-later

#[[
interphase_add_plugin(<name> SOURCES <file>... [LIBRARIES <target>...] [NOT_INSTALLED])

A plug-in: the shared library lib<name>.so, a target <name>, that interphase and interphase-liggghts load by that name. One
of its sources includes <interphase/plugin.hpp> and has INTERPHASE_PLUGIN(...). It is installed into
lib/interphase/plugins, where an interphase of the same prefix finds it, unless it is NOT_INSTALLED.
Used by the plug-ins of interphase's own tree and, after find_package(interphase), by any other project.
LIBRARIES: what it links besides LIGGGHTS and MPI.
]]
function(interphase_add_plugin name)
    cmake_parse_arguments(PARSE_ARGV 1 plugin "NOT_INSTALLED" "" "SOURCES;LIBRARIES")
    if(NOT name MATCHES "^[a-z][a-z0-9_]*$")
        message(FATAL_ERROR "interphase_add_plugin: the name '${name}' is refused; use lower-case letters, digits and '_'")
    endif()
    if(NOT plugin_SOURCES OR plugin_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "interphase_add_plugin(${name}) needs SOURCES; not understood: '${plugin_UNPARSED_ARGUMENTS}'")
    endif()

    add_library(${name} MODULE ${plugin_SOURCES})
    target_link_libraries(${name} PRIVATE interphase::plugin ${plugin_LIBRARIES})
    # The file is found by this name, whatever the project's conventions are.
    set_target_properties(${name} PROPERTIES PREFIX lib SUFFIX .so DEBUG_POSTFIX "")
    # A class that was copied from LIGGGHTS and changed is the plug-in's own, although LIGGGHTS has one of that name; and
    # what is missing is told when the library is linked, not when a run starts.
    target_link_options(${name} PRIVATE -Wl,-Bsymbolic -Wl,--no-undefined)
    if(NOT plugin_NOT_INSTALLED)
        install(TARGETS ${name} LIBRARY DESTINATION lib/interphase/plugins)
    endif()
endfunction()
