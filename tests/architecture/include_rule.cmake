# Checks the house rule of ARCHITECTURE.md: which folder may include and link which other.
# Usage: cmake -DROOT=<source> -P include_rule.cmake     (-DSELFTEST=ON: must find planted faults)
cmake_minimum_required(VERSION 3.25)

# folder = folders it may include besides itself. The only list; ARCHITECTURE.md explains it.
set(rule_native/base "")
set(rule_native/numerics native/base)
set(rule_native/dem native/base)
set(rule_native/friction native/base)
set(rule_native/lga native/base)
set(rule_native/hopper native/base)
set(rule_cases/toml native/base)
set(rule_cases/scene native/base cases/toml)
set(rule_cases/catalog native/base cases/toml cases/scene)
set(rule_cases/measure native/base native/numerics cases/scene)
set(rule_cases/measure/statistics native/base native/numerics)
set(rule_cases/measure/waves native/base native/numerics cases/measure cases/measure/statistics)
foreach(model IN ITEMS bed collision gas hopper pipe discharge)
    set(rule_cases/measure/${model} native/base native/numerics cases/scene cases/measure cases/measure/statistics)
endforeach()
list(APPEND rule_cases/measure/collision cases/measure/bed)  # how plates move
foreach(model IN ITEMS gas pipe)  # one measurement of waves for both
    list(APPEND rule_cases/measure/${model} cases/measure/waves)
endforeach()
set(rule_adapters native/base cases/scene)
set(rule_adapters/process native/base cases/scene)
set(rule_adapters/dump native/base cases/scene)
set(rule_adapters/program native/base cases/scene adapters adapters/process adapters/dump)
set(rule_adapters/native native/base native/dem native/friction native/lga native/hopper cases/scene adapters adapters/dump)
set(rule_adapters/synthetic native/base cases/scene adapters)
foreach(code IN ITEMS lammps_family lammps liggghts yade)
    set(rule_adapters/${code} native/base cases/scene adapters adapters/process adapters/dump
                              adapters/program)
endforeach()
foreach(code IN ITEMS lammps liggghts)
    list(APPEND rule_adapters/${code} adapters/lammps_family)
endforeach()
set(rule_cases/observables native/base cases/toml cases/scene cases/catalog cases/measure)
foreach(model IN ITEMS bed collision gas hopper pipe discharge)
    list(APPEND rule_cases/observables cases/measure/${model})
endforeach()
# Who runs: the codes there are, and running them.
set(rule_adapters/registry native/base cases/toml adapters adapters/native adapters/synthetic
                           adapters/lammps adapters/liggghts adapters/yade)
# tools/new.sh code: rules go above this line
set(rule_adapters/run/store native/base cases/measure)
set(rule_adapters/run native/base cases/scene cases/catalog cases/measure cases/observables adapters
                      adapters/dump adapters/process adapters/registry adapters/run/store)
# What is right, and judging.
set(rule_reference/analytic native/base native/numerics)
set(rule_reference/published native/base cases/toml)
set(rule_reference/compare native/base native/numerics reference/analytic reference/published cases/measure
                           cases/measure/statistics)
set(rule_reference/oracles native/base cases/scene reference/analytic)
set(rule_reference/judge native/base cases/scene cases/catalog cases/measure adapters/run/store
                         reference/compare reference/oracles reference/published)
# What people look at.
set(rule_reports/session native/base cases/scene cases/catalog adapters adapters/registry
                         adapters/run adapters/run/store reference/compare reference/judge
                         reference/published)
set(rule_reports/documents native/base cases/catalog cases/measure adapters/registry
                           adapters/run/store reference/compare reference/judge reports/session)
set(rule_reports/studies native/base native/numerics cases/toml cases/scene cases/catalog cases/measure
                         cases/measure/bed cases/measure/statistics adapters adapters/process
                         adapters/registry adapters/run adapters/run/store reference/analytic
                         reference/compare reference/judge reference/oracles reports/session
                         reports/documents)
set(rule_reports/web native/base cases/catalog cases/measure adapters/registry adapters/run adapters/run/store
                     reference/compare reference/judge reports/session reports/documents
                     reports/studies)
set(rule_reports/terminal native/base adapters/run reports/documents)
# Libraries beside their data, which the program links.
set(rule_tests/bench native/base native/numerics native/dem native/friction native/hopper native/lga cases/scene cases/toml
                     adapters adapters/native adapters/lammps adapters/liggghts adapters/yade
                     adapters/process reports/documents)
set(rule_tests/selftest native/base cases/toml cases/scene cases/catalog adapters adapters/registry
                        adapters/run adapters/run/store reference/compare reference/judge
                        reference/published reports/session reports/documents)
set(rule_app native/base cases/toml cases/scene cases/catalog cases/observables adapters
             adapters/dump adapters/process adapters/registry adapters/run adapters/run/store
             reference/judge reference/oracles reference/published reports/session
             reports/documents reports/studies reports/terminal reports/web tests/bench tests/selftest)

get_cmake_property(rooms VARIABLES)
list(FILTER rooms INCLUDE REGEX "^rule_")
list(TRANSFORM rooms REPLACE "^rule_" "")

# Takes away rooms that need nothing that is left; what remains stands on itself.
function(find_circle result)
    set(left "${rooms}")
    set(before "")
    while(NOT left STREQUAL before)
        set(before "${left}")
        foreach(room IN LISTS before)
            set(needs "${rule_${room}}")
            list(FILTER needs EXCLUDE REGEX "^$")
            set(stands ON)
            foreach(need IN LISTS needs)
                if(need IN_LIST left)
                    set(stands OFF)
                endif()
            endforeach()
            if(stands)
                list(REMOVE_ITEM left "${room}")
            endif()
        endforeach()
    endwhile()
    set(${result} "${left}" PARENT_SCOPE)
endfunction()

# The room of a path: the longest folder that has a rule.
function(room_of path result)
    get_filename_component(folder "${path}" DIRECTORY)
    while(NOT folder STREQUAL "" AND NOT DEFINED "rule_${folder}")
        get_filename_component(folder "${folder}" DIRECTORY)
    endwhile()
    set(${result} "${folder}" PARENT_SCOPE)
endfunction()

function(check_file path text result)
    room_of("${path}" room)
    set(found "${${result}}")
    string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${text}")
    foreach(include IN LISTS includes)
        string(REGEX REPLACE "#include \"([^\"]+)\"" "\\1" target "${include}")
        room_of("${target}" target_room)
        if(target_room STREQUAL "")
            list(APPEND found "${path}: includes \"${target}\", which is in no room: write the path from the top")
        elseif(NOT target_room STREQUAL room AND NOT target_room IN_LIST rule_${room})
            list(APPEND found "${path}: ${room} must not include ${target_room} (\"${target}\")")
        endif()
    endforeach()
    set(${result} "${found}" PARENT_SCOPE)
endfunction()

# crossgrain_library(<room> ... USES <rooms> ...): the link lines.
function(check_links path text result)
    set(found "${${result}}")
    string(REGEX REPLACE "#[^\n]*" "" text "${text}")
    string(REGEX MATCHALL "crossgrain_library\\([^)]*\\)" libraries "${text}")
    foreach(library IN LISTS libraries)
        string(REGEX REPLACE "[ \n]+" ";" words "${library}")
        string(REGEX REPLACE "crossgrain_library\\(([^ \n;)]+).*" "\\1" room "${library}")
        set(in_uses OFF)
        foreach(word IN LISTS words)
            string(REPLACE ")" "" word "${word}")
            if(word STREQUAL "USES")
                set(in_uses ON)
            elseif(word MATCHES "^(SOURCES|LIBRARIES)$")
                set(in_uses OFF)
            elseif(in_uses AND NOT word STREQUAL "" AND NOT word IN_LIST rule_${room})
                list(APPEND found "${path}: ${room} must not link ${word}")
            endif()
        endforeach()
    endforeach()
    set(${result} "${found}" PARENT_SCOPE)
endfunction()

get_filename_component(ROOT "${ROOT}" ABSOLUTE)
set(errors "")
if(SELFTEST)
    # The judge is judged: each of these must be found.
    check_file(native/dem/x.cpp "#include \"cases/scene/scene.hpp\"" errors)
    check_file(adapters/lammps/x.cpp "#include \"native/dem/engine.hpp\"" errors)
    check_file(reference/analytic/x.cpp "#include \"native/dem/engine.hpp\"" errors)
    check_file(cases/scene/x.cpp "#include \"scene.hpp\"" errors)
    check_file(cases/measure/statistics/x.cpp "#include \"cases/measure/gas/gas_flux.hpp\"" errors)
    check_file(cases/measure/pipe/x.cpp "#include \"cases/measure/gas/gas_flux.hpp\"" errors)
    check_file(adapters/run/x.cpp "#include \"reference/judge/evaluate.hpp\"" errors)
    check_file(reports/studies/x.cpp "#include \"app/settings.hpp\"" errors)
    check_links(CMakeLists.txt "crossgrain_library(native/dem\n SOURCES a.cpp\n USES cases/scene)" errors)
    set(rule_native/base cases/toml)
    find_circle(circle)
    if(NOT "native/base" IN_LIST circle)
        message(FATAL_ERROR "a circle between native/base and cases/toml was not found")
    endif()
    list(LENGTH errors count)
    if(NOT count EQUAL 9)
        message(FATAL_ERROR "9 planted faults, found ${count}: ${errors}")
    endif()
    message(STATUS "all 9 planted faults were found")
    return()
endif()

find_circle(circle)
if(circle)
    message(FATAL_ERROR "these rooms need each other in a circle, or need one of a circle: ${circle}")
endif()

set(files 0)
foreach(top IN ITEMS native cases adapters reference reports app tests/bench tests/selftest)
    file(GLOB_RECURSE sources RELATIVE "${ROOT}" "${ROOT}/${top}/*.hpp" "${ROOT}/${top}/*.cpp")
    list(FILTER sources EXCLUDE REGEX "_test[.]cpp$")
    foreach(source IN LISTS sources)
        file(READ "${ROOT}/${source}" text)
        check_file("${source}" "${text}" errors)
        math(EXPR files "${files} + 1")
    endforeach()
    file(GLOB_RECURSE lists RELATIVE "${ROOT}" "${ROOT}/${top}/CMakeLists.txt")
    foreach(list_file IN LISTS lists)
        file(READ "${ROOT}/${list_file}" text)
        check_links("${list_file}" "${text}" errors)
    endforeach()
endforeach()
if(files EQUAL 0)
    message(FATAL_ERROR "no source found below ${ROOT}")
endif()
if(errors)
    list(JOIN errors "\n  " text)
    message(FATAL_ERROR "the include rule of ARCHITECTURE.md is broken:\n  ${text}")
endif()
message(STATUS "${files} sources keep the include rule")
