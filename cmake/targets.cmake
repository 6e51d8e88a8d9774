# How every library and test of this project is declared, so that flags and names are in one place.

add_library(crossgrain_flags INTERFACE)
target_compile_options(crossgrain_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
    # Designated initialisers leave members at their defaults on purpose; g++ 12 warns of that.
    -Wno-missing-field-initializers
    # False alarms of g++ 12 in std::string's own assignment (GCC bug 105329).
    -Wno-restrict
    # Trajectory parity to the last digits needs one rounding per operation, on every machine.
    -ffp-contract=off)
if(CROSSGRAIN_SANITIZE)
    target_compile_options(crossgrain_flags INTERFACE -fsanitize=${CROSSGRAIN_SANITIZE}
                                                      -fno-sanitize-recover=all)
    target_link_options(crossgrain_flags INTERFACE -fsanitize=${CROSSGRAIN_SANITIZE})
endif()
if(CROSSGRAIN_SANITIZE AND NOT CROSSGRAIN_FUZZ)
    # A kernel is compiled once per instruction set, which takes minutes with sanitizers; so it is
    # compiled for this machine alone.
    target_compile_options(crossgrain_flags INTERFACE -march=native
        # False alarms of g++ 12 in std::regex, with sanitizers only (GCC bug 105562).
        -Wno-maybe-uninitialized)
    if(CROSSGRAIN_SANITIZE STREQUAL "thread")
        # Highway's fence keeps registers free; no thread synchronises with another by it.
        target_compile_options(crossgrain_flags INTERFACE -Wno-tsan)
    endif()
endif()
if(CROSSGRAIN_FUZZ)
    target_compile_options(crossgrain_flags INTERFACE -fsanitize=fuzzer-no-link)
    # The first clang that knows all warnings of g++ 12 by name is not Debian's.
    target_compile_options(crossgrain_flags INTERFACE -Wno-unknown-warning-option)
endif()

# For targets whose sources include Eigen: with sanitizers g++ 12 raises false alarms in its own
# AVX-512 headers (GCC bug 105593).
function(crossgrain_uses_eigen target)
    if(CROSSGRAIN_SANITIZE AND NOT CROSSGRAIN_FUZZ)
        target_compile_options(${target} PRIVATE -Wno-uninitialized)
    endif()
endfunction()

# crossgrain_library(<folder> SOURCES ... [USES <folder>...] [LIBRARIES <third party>...])
# <folder> is the path from the top, e.g. cases/scene; USES is checked against the rule of
# ARCHITECTURE.md by tests/architecture.
function(crossgrain_library folder)
    cmake_parse_arguments(arg "" "" "SOURCES;USES;LIBRARIES" ${ARGN})
    string(REPLACE "/" "_" name "crossgrain_${folder}")
    add_library(${name} STATIC ${arg_SOURCES})
    target_include_directories(${name} PUBLIC "${PROJECT_SOURCE_DIR}")
    foreach(used IN LISTS arg_USES)
        string(REPLACE "/" "_" used_name "crossgrain_${used}")
        target_link_libraries(${name} PUBLIC ${used_name})
    endforeach()
    foreach(library IN LISTS arg_LIBRARIES)
        # Third-party headers are SYSTEM: their warnings are not ours.
        target_link_libraries(${name} PUBLIC ${library})
    endforeach()
    target_link_libraries(${name} PRIVATE crossgrain_flags)
endfunction()

# crossgrain_test(<name> LABELS ... SOURCES ... USES ... [LIBRARIES ...] [TIMEOUT s])
function(crossgrain_test name)
    cmake_parse_arguments(arg "" "TIMEOUT" "SOURCES;USES;LIBRARIES;LABELS" ${ARGN})
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 120)
    endif()
    add_executable(test_${name} ${arg_SOURCES})
    set_target_properties(test_${name} PROPERTIES
                          RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
    target_compile_definitions(test_${name} PRIVATE
        BOOST_TEST_DYN_LINK BOOST_TEST_MODULE=${name}
        CROSSGRAIN_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    foreach(used IN LISTS arg_USES)
        string(REPLACE "/" "_" used_name "crossgrain_${used}")
        target_link_libraries(test_${name} PRIVATE ${used_name})
    endforeach()
    target_link_libraries(test_${name} PRIVATE ${arg_LIBRARIES} Boost::unit_test_framework
                                               crossgrain_flags)
    add_test(NAME ${name} COMMAND test_${name})
    set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT})
endfunction()

# crossgrain_share(<name>): the *.toml files of this folder travel with the binary, in
# <build>/share/crossgrain/<name>.
function(crossgrain_share name)
    file(GLOB files CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.toml")
    set(share "${CMAKE_BINARY_DIR}/share/crossgrain/${name}")
    set(copies "")
    foreach(file IN LISTS files)
        get_filename_component(file_name "${file}" NAME)
        add_custom_command(OUTPUT "${share}/${file_name}" DEPENDS "${file}"
            COMMAND ${CMAKE_COMMAND} -E copy "${file}" "${share}/${file_name}")
        list(APPEND copies "${share}/${file_name}")
    endforeach()
    string(REPLACE "/" "_" target "share_${name}")
    add_custom_target(${target} ALL DEPENDS ${copies})
endfunction()
