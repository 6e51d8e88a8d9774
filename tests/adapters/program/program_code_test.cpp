// Programs that fail in every way that was seen, and some more: fault injection by shell scripts
// that stand where a code's program would stand.
#include "adapters/program/error_line.hpp"
#include "adapters/program/program_code.hpp"
#include "native/base/errors.hpp"
#include "tests/support/adapter_run.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/zstd_text.hpp"

#include <boost/test/unit_test.hpp>

#include <atomic>
#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

using namespace crossgrain;
using adapters::Availability;
using adapters::InputFile;

namespace {

/// Runs a shell script instead of a code.
class ShellCode final : public adapters::ProgramCode {
  public:
    explicit ShellCode(std::string script, std::string program = "sh")
        : ProgramCode(std::move(program)), script_(std::move(script)) {}

    [[nodiscard]] std::string name() const override { return "shell"; }
    [[nodiscard]] std::vector<std::string> features() const override { return {}; }
    [[nodiscard]] std::optional<std::string>
    cannot_express(const scene::Scene& scene) const override {
        if (scene.contact.spins == scene::Spins::on) return "shells do not spin";
        return std::nullopt;
    }
    [[nodiscard]] std::vector<InputFile> input(const scene::Scene&) const override {
        return {{.name = "run.sh", .text = script_}};
    }

    [[nodiscard]] int times_asked() const { return times_asked_; }

  protected:
    [[nodiscard]] std::vector<std::string> version_arguments() const override {
        return {"-c", "echo shell 7"};
    }
    [[nodiscard]] Availability availability_from(const std::string& answer) const override {
        ++times_asked_;
        if (answer != "shell 7\n") return {.reason = "'" + program() + "' is no shell"};
        return {.installed = true, .version = "7"};
    }
    [[nodiscard]] std::vector<std::string> run_arguments() const override { return {"run.sh"}; }
    [[nodiscard]] std::vector<std::string> environment() const override { return {"LAST=2"}; }
    [[nodiscard]] std::optional<std::string> error_in(const std::string& out,
                                                      const std::string&) const override {
        return adapters::line_starting_with(out, "ERROR");
    }

  private:
    std::string script_;
    mutable std::atomic<int> times_asked_ = 0;
};

/// Frames at steps 0, 1, 2.
scene::Scene short_pair() {
    auto scene = tests::head_on_pair();
    scene.initial = {.x = {0, 3}, .y = {0, 0}, .vx = {1, 0}, .vy = {0, 0}};
    scene.dt = 0.01;
    scene.steps = 2;
    scene.frame_every = 1;
    return scene;
}

/// A shell function that writes the frame of one step: `frame <step> <x of the first grain>`.
const std::string frame_function =
    "frame() { printf 'ITEM: TIMESTEP\\n%s\\nITEM: NUMBER OF ATOMS\\n2\\n"
    "ITEM: BOX BOUNDS ss ss pp\\n-5 5\\n-5 5\\n-1 1\\nITEM: ATOMS id type xu yu vx vy\\n"
    "1 1 %s 0 1 0\\n2 1 3 0 0 0\\n' $1 $2; }\n";

/// All frames with exit status 0: what each test below breaks.
const std::string good =
    frame_function + "{ frame 0 0; frame 1 .01; frame 2 .02; } >trajectory.dump\n";

struct Outcome {
    int frames = 0;
    AdapterErrorDetails error;
};

Outcome outcome_of(const ShellCode& code, const scene::Scene& scene = short_pair(),
                   double time_limit = 20) {
    const tests::TemporaryDirectory directory;
    Outcome outcome;
    try {
        code.run(scene, {.directory = directory.path(), .time_limit = time_limit, .stop = {}},
                 [&](const scene::Frame&) { ++outcome.frames; });
    } catch (const AdapterError& error) {
        outcome.error = error.details();
        BOOST_TEST(outcome.error.code == "shell");
        BOOST_TEST(outcome.error.directory == directory.path().string());
    }
    return outcome;
}

}  // namespace

BOOST_AUTO_TEST_CASE(program_is_asked_once_what_it_is) {
    const ShellCode code(good);
    {
        std::vector<std::jthread> askers;
        for (int i = 0; i < 4; ++i)
            askers.emplace_back([&code] { (void)code.probe(); });
    }
    BOOST_TEST(code.probe().installed);
    BOOST_TEST(code.probe().version == "7");
    BOOST_TEST(code.times_asked() == 1);
}

BOOST_AUTO_TEST_CASE(program_of_no_use_has_a_reason) {
    const auto reason = [](const std::string& program) {
        const auto availability = ShellCode(good, program).probe();
        BOOST_TEST(!availability.installed);
        return availability.reason;
    };
    BOOST_TEST(reason("crossgrain-no-such-program") == "no 'crossgrain-no-such-program' on PATH");
    BOOST_TEST(reason("true") == "'true' is no shell");
    const tests::TemporaryDirectory directory;
    const auto broken = directory.path() / "broken";
    std::ofstream(broken) << "#!/crossgrain/no/such/interpreter\n";
    std::filesystem::permissions(broken, std::filesystem::perms::owner_all);
    BOOST_TEST(reason(broken.string()) ==
               "'" + broken.string() + " -c echo shell 7' does not run: cannot start " +
                   broken.string() + ", its interpreter is missing: No such file or directory");
}

BOOST_AUTO_TEST_CASE(a_good_run_delivers_and_reports_its_cost) {
    const tests::TemporaryDirectory directory;
    std::vector<double> x;
    const auto cost =
        ShellCode(good + "[ $LAST = 2 ]\n")
            .run(short_pair(),
                 {.directory = directory.path(), .time_limit = 20, .stop = {}, .keep_dump = true},
                 [&](const scene::Frame& frame) { x.push_back(frame.x[0]); });
    BOOST_TEST(x == (std::vector<double>{0.0, 0.01, 0.02}), boost::test_tools::per_element());
    BOOST_TEST(cost.cpu_s > 0);
    BOOST_TEST(cost.wall_s > 0);
    const auto text = tests::unpacked_file(directory.path() / adapters::kept_dump_name);
    BOOST_TEST(text.find("ITEM: TIMESTEP\n2\n") != std::string::npos);
    BOOST_TEST(text.ends_with("1 1 .02 0 1 0\n2 1 3 0 0 0\n"));
}

BOOST_AUTO_TEST_CASE(no_dump_is_kept_unless_asked) {
    const tests::TemporaryDirectory directory;
    ShellCode(good).run(short_pair(), {.directory = directory.path(), .time_limit = 20, .stop = {}},
                        [](const auto&) {});
    BOOST_TEST(!std::filesystem::exists(directory.path() / adapters::kept_dump_name));
}

BOOST_AUTO_TEST_CASE(error_text_counts_although_all_else_is_fine) {
    const auto outcome = outcome_of(ShellCode(good + "echo all well; echo 'ERROR: lost atoms'\n"));
    BOOST_TEST(outcome.frames == 3);
    BOOST_TEST(outcome.error.reason == "ERROR: lost atoms");
    BOOST_TEST(outcome.error.exit == "exit status 0");
    BOOST_TEST(outcome.error.command == "sh run.sh");
    BOOST_TEST(outcome.error.log_tail == "all well\nERROR: lost atoms");
}

BOOST_AUTO_TEST_CASE(error_text_says_more_than_status_and_missing_frames) {
    const auto outcome = outcome_of(ShellCode("echo ERROR: bad input; exit 1"));
    BOOST_TEST(outcome.error.reason == "ERROR: bad input");
    BOOST_TEST(outcome.error.exit == "exit status 1");
}

BOOST_AUTO_TEST_CASE(exit_status_and_signal) {
    const auto status = outcome_of(ShellCode(good + "echo oops >&2; exit 7")).error;
    BOOST_TEST(status.reason == "exit status 7, without an error message");
    BOOST_TEST(status.log_tail == "oops");
    BOOST_TEST(outcome_of(ShellCode(good + "kill -SEGV $$")).error.reason ==
               "killed by signal 11, without an error message");
}

BOOST_AUTO_TEST_CASE(missing_frames) {
    BOOST_TEST(outcome_of(ShellCode("true")).error.reason == "dump holds no frame");
    BOOST_TEST(outcome_of(ShellCode(frame_function + "{ frame 0 0; frame 1 0; } >trajectory.dump"))
                   .error.reason == "trajectory ends before step 2 (2 of 3 frames)");
    BOOST_TEST(outcome_of(ShellCode(frame_function + "frame 0 0 | head -c 120 >trajectory.dump"))
                   .error.reason ==
               "dump ends in the middle of the frame at step 0 (after line 9)");
}

BOOST_AUTO_TEST_CASE(frames_that_cannot_be_end_the_program) {
    const auto reason = [](const std::string& frames) {
        const auto start = std::chrono::steady_clock::now();
        const auto outcome = outcome_of(
            ShellCode(frame_function + "{ " + frames + "; } >trajectory.dump; sleep 60"));
        BOOST_TEST((std::chrono::steady_clock::now() - start < std::chrono::seconds(10)));
        BOOST_TEST(outcome.error.exit == "ended because of its trajectory");
        return outcome.error.reason;
    };
    BOOST_TEST(reason("frame 0 0; frame 1 nan") ==
               "dump, line 21: 'nan' in column x is not finite");
    BOOST_TEST(reason("frame 0 0; frame 2 0").starts_with("frame at step 1 is missing"));
    BOOST_TEST(reason("frame 0 0; frame 0 0").find("frames overlap") != std::string::npos);
    BOOST_TEST(reason("frame 0 0; frame 1 0; frame 2 0; frame 3 0")
                   .starts_with("frame at step 3 lies beyond"));
}

BOOST_AUTO_TEST_CASE(hanging_program_is_ended_at_the_time_limit) {
    const auto outcome = outcome_of(
        ShellCode(frame_function + "frame 0 0 >trajectory.dump; sleep 60"), short_pair(), 0.5);
    BOOST_TEST(outcome.frames == 1);
    BOOST_TEST(outcome.error.reason == "not finished within 0.5 s (1 frames so far)");
    BOOST_TEST(outcome.error.exit == "killed at the time limit of 0.5 s");
}

BOOST_AUTO_TEST_CASE(program_that_ends_well_only_when_terminated_is_not_finished) {
    // As LIGGGHTS does: status 0 after SIGTERM.
    const auto outcome = outcome_of(
        ShellCode(good + "trap 'exit 0' TERM; while true; do sleep .05; done"), short_pair(), 0.5);
    BOOST_TEST(outcome.error.exit == "killed at the time limit of 0.5 s");
}

BOOST_AUTO_TEST_CASE(stop_request_is_an_interruption) {
    const tests::TemporaryDirectory directory;
    std::stop_source source;
    std::jthread stopper([&source] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        source.request_stop();
    });
    BOOST_CHECK_THROW(
        ShellCode("sleep 60")
            .run(short_pair(),
                 {.directory = directory.path(), .time_limit = 30, .stop = source.get_token()},
                 [](const auto&) {}),
        Interrupted);
}

BOOST_AUTO_TEST_CASE(what_the_sink_throws_ends_the_program_and_comes_back) {
    const tests::TemporaryDirectory directory;
    const auto run_into = [&](const scene::FrameSink& sink) {
        const tests::TemporaryDirectory place;
        ShellCode(good + "sleep 60")
            .run(short_pair(), {.directory = place.path(), .time_limit = 30, .stop = {}}, sink);
    };
    BOOST_CHECK_THROW(run_into([](const auto&) { throw Interrupted(); }), Interrupted);
    BOOST_CHECK_THROW(run_into([](const auto&) { throw std::logic_error("mine"); }),
                      std::logic_error);
    BOOST_CHECK_THROW(run_into([](const auto&) {
                          throw std::system_error(std::make_error_code(std::errc::io_error));
                      }),
                      std::system_error);
    // A measurement may find that the trajectory cannot be what it should be.
    BOOST_CHECK_THROW(run_into([](const auto&) { throw TrajectoryError("overlap"); }),
                      AdapterError);
}

BOOST_AUTO_TEST_CASE(program_that_is_not_there) {
    const auto error = outcome_of(ShellCode(good, "crossgrain-no-such-program")).error;
    BOOST_TEST(error.reason == "no 'crossgrain-no-such-program' on PATH");
    BOOST_TEST(error.exit == "not started");
}

BOOST_AUTO_TEST_CASE(scene_that_cannot_be_expressed_is_not_run) {
    auto scene = short_pair();
    scene.contact.spins = scene::Spins::on;
    const auto error = outcome_of(ShellCode(good), scene).error;
    BOOST_TEST(error.reason == "cannot express this scene: shells do not spin");
}

BOOST_AUTO_TEST_CASE(copy_that_cannot_be_written) {
    const tests::TemporaryDirectory directory;
    std::filesystem::create_directory(directory.path() / adapters::kept_dump_name);
    BOOST_CHECK_EXCEPTION(
        ShellCode(good).run(
            short_pair(),
            {.directory = directory.path(), .time_limit = 20, .stop = {}, .keep_dump = true},
            [](const auto&) {}),
        AdapterError, [](const AdapterError& error) {
            return error.details().reason.starts_with("cannot write ");
        });
}

BOOST_AUTO_TEST_CASE(error_lines) {
    using adapters::line_starting_with;
    BOOST_TEST(line_starting_with("fine\n  ERROR: here \r\nERROR: there", "ERROR").value() ==
               "ERROR: here");
    BOOST_TEST(line_starting_with("ERROR", "ERROR").value() == "ERROR");
    BOOST_TEST(!line_starting_with("no ERROR at the start\n\n   \n", "ERROR"));
    BOOST_TEST(!line_starting_with("", "ERROR"));
}
