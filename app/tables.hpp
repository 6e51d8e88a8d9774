// What a call prints for people: measurements by code, verdicts, certificate, history.
#pragma once

#include "app/history.hpp"
#include "app/session.hpp"

#include <string>

namespace crossgrain::app {

[[nodiscard]] std::string case_table(const CaseReport& item);
/// Cases against codes: how many verdicts of each outcome.
[[nodiscard]] std::string verdict_table(const SessionReport& report);
/// Empty without a case that has a parity check.
[[nodiscard]] std::string certificate_table(const SessionReport& report);
[[nodiscard]] std::string history_table(const std::vector<HistorySeries>& history);
/// Everything that is neither agreement nor expected, one line each with its reason.
[[nodiscard]] std::string exceptions_list(const SessionReport& report);

}  // namespace crossgrain::app
