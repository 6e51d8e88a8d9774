#include "adapters/process/question.hpp"

#include "adapters/process/log_file.hpp"
#include "adapters/process/scratch_directory.hpp"
#include "adapters/process/temporary_base.hpp"

namespace crossgrain::adapters::process {

Answer ask(const Question& question) {
    const auto base = temporary_base();
    sweep(base);
    const ScratchDirectory directory(base, "probe");
    const Result result = run({.argv = question.argv,
                               .directory = directory.path(),
                               .extra_environment = question.extra_environment,
                               .time_limit = question.time_limit,
                               .stop = question.stop,
                               .largest_log = longest_answer});
    return {.ending = result.ending,
            .status = result.status,
            .ended = describe(result, question.time_limit),
            .out = read_text(result.stdout_file, longest_answer),
            .err = read_text(result.stderr_file, longest_answer)};
}

}  // namespace crossgrain::adapters::process
