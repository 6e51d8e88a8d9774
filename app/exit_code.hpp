// Exit codes of the program; scripts rely on them.
#pragma once

#include "app/settings.hpp"
#include "reports/session/session.hpp"

namespace crossgrain::app {

enum ExitCode : int {
    exit_ok = 0,          ///< every verdict is `agree` or as expected
    exit_verdict = 1,     ///< an unexpected verdict or a regression
    exit_usage = 2,       ///< bad usage or bad input
    exit_run_failed = 3,  ///< a run failed, a code asked for is absent, or output is lost
    exit_interrupted = 130
};

/// Of a call that ran or read these cases.
[[nodiscard]] int exit_code(const session::SessionReport& report, const Settings& settings);

}  // namespace crossgrain::app
