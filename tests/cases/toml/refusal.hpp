// What a reader says about bad input, for tests of everything that throws a CaseError.
#pragma once

#include "native/base/errors.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

namespace crossgrain::tests {

/// The details of the CaseError that `read` throws; the test fails if it throws none.
template <class Read>
CaseErrorDetails refusal(Read read) {
    try {
        read();
    } catch (const CaseError& error) {
        const std::string line = error.what();
        BOOST_TEST(line.find('\n') == std::string::npos, "more than one line: " << line);
        return error.details();
    }
    BOOST_ERROR("bad input was accepted");
    return {};
}

}  // namespace crossgrain::tests
