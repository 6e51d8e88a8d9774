// Frames that were kept are measured to the same bits; what is cut off, altered, of other frames or
// no file at all is refused with its reason.
#include "adapters/dump/dump_writer.hpp"
#include "adapters/run/kept_frames.hpp"
#include "adapters/run/measured_dump.hpp"
#include "native/base/errors.hpp"
#include "tests/support/kept_frames.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/zstd_text.hpp"

#include <boost/test/unit_test.hpp>
#include <fmt/format.h>

#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

using namespace crossgrain;
namespace fs = std::filesystem;

namespace {

const run::FramesIdentity identity{std::string(64, 'a'), "lammps", "7"};
/// Another one that has the same place.
const run::FramesIdentity alike{std::string(60, 'a') + "bbbb", "lammps", "7"};

/// Keeps what it is told.
class Listener final : public run::Monitor {
  public:
    void note(const std::string& line) override { notes.push_back(line); }
    void remark(const std::string& /*line*/) override {}
    std::unique_ptr<run::Progress> begin(std::size_t runs, double seconds,
                                         unsigned workers) override {
        return run::silent_monitor().begin(runs, seconds, workers);
    }
    std::vector<std::string> notes;
};

std::string dump_of(const scene::Scene& scene) {
    std::ostringstream out;
    adapters::dump::DumpWriter writer(scene, out);
    for (const auto& frame : tests::reference_frames(scene))
        writer(frame.view());
    return out.str();
}

/// A directory of runs with the frames of a small gas.
struct Runs {
    Runs() {
        fs::create_directory(directory);
        tests::pack_into(dump, dump_of(scene));
        run::record_frames(directory, identity, {.cpu_s = 1.5, .wall_s = 2.5});
    }
    [[nodiscard]] std::optional<run::KeptFrames>
    found(const run::FramesIdentity& frames = identity) {
        return run::find_frames(parent.path(), frames, listener, {});
    }
    /// Why the frames are refused.
    [[nodiscard]] std::string refusal(const run::FramesIdentity& frames = identity) {
        listener.notes.clear();
        if (found(frames)) return "accepted";
        return listener.notes.size() == 1 ? listener.notes.front() : "not one note";
    }
    void replace_in_record(const std::string& from, const std::string& to) const {
        std::string text = tests::bytes_of(record);
        const auto at = text.find(from);
        BOOST_TEST_REQUIRE((at != std::string::npos), from);
        std::ofstream(record) << text.replace(at, from.size(), to);
    }

    scene::Scene scene = tests::small_gas(1e-3);
    tests::TemporaryDirectory parent;
    fs::path directory = parent.path() / (run::frames_directory_stem("gas", identity, 0) + "-123");
    fs::path dump = directory / adapters::kept_dump_name, record = directory / "frames.json";
    Listener listener;
};

bool says(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

catalog::Case case_of(const std::vector<std::string>& observables) {
    catalog::Case the_case;
    for (const auto& name : observables)
        the_case.observables.push_back({.name = name});
    return the_case;
}

}  // namespace

BOOST_AUTO_TEST_CASE(frames_are_found_by_their_key_whatever_the_run_was_called) {
    Runs runs;
    const auto kept = runs.found();
    BOOST_TEST_REQUIRE(kept.has_value());
    BOOST_TEST(kept->dump == runs.dump);
    BOOST_TEST(kept->cost.cpu_s == 1.5);
    BOOST_TEST(kept->cost.wall_s == 2.5);
    fs::rename(runs.directory,
               runs.parent.path() / (run::frames_directory_stem("renamed", identity, 4) + "-9-2"));
    BOOST_TEST(runs.found().has_value());
    BOOST_TEST(!runs.found({std::string(64, 'c'), "lammps", "7"}));
    BOOST_TEST(runs.listener.notes.empty());
}

BOOST_AUTO_TEST_CASE(a_directory_without_a_record_holds_no_frames) {
    Runs runs;
    fs::remove(runs.record);  // of a run that failed
    BOOST_TEST(!runs.found());
    BOOST_TEST(runs.listener.notes.empty());
    BOOST_TEST(!run::find_frames(runs.parent.path() / "missing", identity, runs.listener, {}));
}

BOOST_AUTO_TEST_CASE(kept_frames_pass_the_reader_and_the_estimators) {
    Runs runs;
    int passed = 0;
    const auto results = run::measure_frames(case_of({"momentum"}), runs.scene, runs.dump,
                                             [&](const auto&) { ++passed; }, {});
    BOOST_TEST(passed == 11);
    BOOST_TEST(!results.measurements.empty());
    std::stop_source stop;
    stop.request_stop();
    BOOST_CHECK_THROW(
        (void)run::measure_frames(
            case_of({"momentum"}), runs.scene, runs.dump, [](const auto&) {}, stop.get_token()),
        Interrupted);
    // Frames of another scene, and a schedule that is not over.
    BOOST_CHECK_THROW((void)run::measure_frames(case_of({"momentum"}), tests::small_bed(1e-3),
                                                runs.dump, [](const auto&) {}, {}),
                      TrajectoryError);
    auto longer = runs.scene;
    longer.steps += longer.frame_every;
    BOOST_CHECK_THROW(
        (void)run::measure_frames(case_of({"momentum"}), longer, runs.dump, [](const auto&) {}, {}),
        TrajectoryError);
}

BOOST_AUTO_TEST_CASE(a_dump_that_is_not_the_recorded_one_is_refused) {
    Runs runs;
    BOOST_TEST(runs.refusal() == "accepted");
    const std::string whole = tests::bytes_of(runs.dump);
    std::ofstream(runs.dump, std::ios::binary) << whole.substr(0, whole.size() / 2);
    BOOST_TEST(says(runs.refusal(), fmt::format("holds {} bytes, {} were recorded",
                                                whole.size() / 2, whole.size())));
    std::string altered = whole;
    altered[whole.size() / 2] = static_cast<char>(altered[whole.size() / 2] ^ 1);
    std::ofstream(runs.dump, std::ios::binary) << altered;
    BOOST_TEST(says(runs.refusal(), "was changed since it was recorded"));
    fs::remove(runs.dump);
    BOOST_TEST(says(runs.refusal(), "dump.txt.zst is no regular file"));
    fs::create_symlink("/dev/zero", runs.dump);
    BOOST_TEST(says(runs.refusal(), "dump.txt.zst is no regular file"));
}

BOOST_AUTO_TEST_CASE(a_record_that_is_none_is_refused) {
    BOOST_TEST(says(Runs().refusal(alike), "frames.json is of frames aaaa"));
    BOOST_TEST(says(Runs().refusal({identity.key, "yade", "7"}), "is of code lammps, not yade"));
    BOOST_TEST(says(Runs().refusal({identity.key, "lammps", "8"}), "is of version 7, not 8"));
    const auto with = [](const std::string& from, const std::string& to) {
        Runs runs;
        runs.replace_in_record(from, to);
        return runs.refusal();
    };
    BOOST_TEST(says(with("\"format\": 1", "\"format\": 2"), "another format"));
    BOOST_TEST(says(with("1.5", "-1.5"), "cpu_s = -1.5"));
    BOOST_TEST(says(with("2.5", "\"long\""), "must be number"));
    BOOST_TEST(says(with("\"sha256\"", "\"sha\""), "sha256"));
    BOOST_TEST(says(with("}", ""), "cannot be measured again"));
    Runs runs;
    std::ofstream(runs.record) << std::string(20'000, '[');
    BOOST_TEST(says(runs.refusal(), "longer than a record"));
    std::ofstream(runs.record) << std::string(5'000, '[');
    BOOST_TEST(says(runs.refusal(), "cannot be measured again"));
    fs::remove(runs.record);
    fs::create_directory(runs.record);
    BOOST_TEST(says(runs.refusal(), "frames.json is no regular file"));
}
