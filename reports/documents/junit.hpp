// JUnit XML of the verdicts, for continuous integration.
//
// agree, as expected        -> passed
// disagree, as expected     -> passed, with the recorded reason as text
// anything not as expected  -> failure (also an expected disagreement that starts to agree)
// run_failed                -> error
// not_installed, not_expressible, undecided, no_reference, as expected -> skipped with the reason
// an outcome this file does not know -> error
//
// Only `agree` may be taken for granted: a verdict without "expected" is unexpected unless it
// agrees or could not be asked (not_installed, not_expressible).
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace crossgrain::reports {

/// One suite per case and one for the certificate; schema of `document` in reports/web/README.md.
[[nodiscard]] std::string junit_xml(const nlohmann::json& document);

}  // namespace crossgrain::reports
