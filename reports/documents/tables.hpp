// What a call prints for people: measurements by code, verdicts, certificate.
#pragma once

#include "reports/session/session.hpp"

#include <string>

namespace crossgrain::reports {

[[nodiscard]] std::string case_table(const judge::CaseReport& item);
/// Cases against codes: how many verdicts of each outcome.
[[nodiscard]] std::string verdict_table(const session::SessionReport& report);
/// Empty without a case that has a parity check.
[[nodiscard]] std::string certificate_table(const session::SessionReport& report);
/// "restitution [clip-all] lammps against analytic:restitution".
[[nodiscard]] std::string question_text(const compare::Verdict& verdict);
/// Everything that is neither agreement nor expected, one line each with its reason.
[[nodiscard]] std::string exceptions_list(const session::SessionReport& report);

}  // namespace crossgrain::reports
