// Tests that need a foreign program are skipped, visibly, where it is not installed. Use
//     BOOST_TEST_GLOBAL_FIXTURE(NeedsLammps);   // using NeedsLammps = NeedsCode<LammpsCode>;
// and in CMake  set_tests_properties(<name> PROPERTIES SKIP_RETURN_CODE 77).
#pragma once

#include <cstdlib>
#include <iostream>

namespace crossgrain::tests {

inline constexpr int skip_return_code = 77;

template <class Code>
struct NeedsCode {
    NeedsCode() {
        const Code code;
        const auto availability = code.probe();
        if (availability.installed) return;
        std::cerr << "SKIPPED: " << code.name() << " is not available: " << availability.reason
                  << std::endl;
        std::_Exit(skip_return_code);
    }
};

}  // namespace crossgrain::tests
