// The JSON that other tools rely on.
#pragma once

#include "reference/judge/case_report.hpp"
#include "reports/session/session.hpp"

#include <nlohmann/json_fwd.hpp>

#include <stop_token>

namespace crossgrain::reports {

/// {"codes": [{code, version, program, digest, status, reason, expresses}]}. Throws Interrupted.
[[nodiscard]] nlohmann::json codes_document(std::stop_token stop = {});

/// {case, runs, measurements, verdicts} of one case.
[[nodiscard]] nlohmann::json case_document(const judge::CaseReport& item);

/// {"cases": [{case, runs, measurements, verdicts}]}, the answer of run and compare.
[[nodiscard]] nlohmann::json cases_document(const session::SessionReport& report);

/// {"pairs": [...]}, the answer of certify.
[[nodiscard]] nlohmann::json certificate_document(const session::SessionReport& report);

}  // namespace crossgrain::reports
