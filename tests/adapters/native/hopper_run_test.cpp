// The frames of a hopper run are the engine's own states on the schedule that the scene asks for;
// the input says all there is to know; stops and bad scenes end a run as they should.
#include "adapters/native/native_hopper_code.hpp"
#include "native/base/errors.hpp"
#include "native/hopper/engine.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <fstream>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

using namespace crossgrain;
using adapters::NativeHopperCode;

namespace {

const NativeHopperCode code("0.1.0 (engine 1a2b3c4d)");

scene::HopperAutomaton small_scene() {
    scene::HopperAutomaton s;
    s.name = "hopper/test";
    s.outlet = 6;
    s.levels = 30;
    s.angles = {20, 60};
    s.c_d = 0.01;
    s.c_i = 0.1;
    s.c_w = 10;
    s.iterations = 25;
    s.every = 10;
    s.replicas = 2;
    s.seed = 11;
    return s;
}

/// A frame with its views copied.
struct Kept {
    std::size_t angle_index = 0;
    double angle = 0;
    int replica = 0;
    std::int64_t iteration = 0;
    bool last = false;
    std::vector<std::uint8_t> state, twin;
    std::vector<std::uint32_t> flow;
    std::int64_t moves = 0;
    std::int32_t left_reach = -1, right_reach = -1;
    std::size_t sites = 0;  // of all levels
    friend bool operator==(const Kept&, const Kept&) = default;
};

Kept keep(const scene::HopperFrame& f) {
    Kept k{f.angle_index, f.angle,      f.replica,    f.iteration, f.last, {}, {}, {},
           f.moves,       f.left_reach, f.right_reach};
    k.state.assign(f.state.begin(), f.state.end());
    k.twin.assign(f.twin.begin(), f.twin.end());
    k.flow.assign(f.flow.begin(), f.flow.end());
    for (const auto& level : f.levels)
        k.sites += level.sites();
    return k;
}

std::vector<Kept> frames(const scene::HopperAutomaton& s, bool keep_dump = false,
                         const std::filesystem::path& directory = {}) {
    std::vector<Kept> kept;
    const auto cost =
        code.run(s, {.directory = directory, .time_limit = 60, .stop = {}, .keep_dump = keep_dump},
                 [&](const scene::HopperFrame& frame) { kept.push_back(keep(frame)); });
    BOOST_TEST(cost.cpu_s > 0);
    BOOST_TEST(cost.wall_s > 0);
    return kept;
}

}  // namespace

BOOST_AUTO_TEST_CASE(it_is_installed_and_says_what_it_can_do) {
    BOOST_TEST(code.name() == "native-hopper");
    BOOST_TEST(code.probe().installed);
    BOOST_TEST(code.probe().version == "0.1.0 (engine 1a2b3c4d)");
    BOOST_TEST(!code.features().empty());
}

BOOST_AUTO_TEST_CASE(frames_come_angle_by_angle_and_replica_by_replica_on_schedule) {
    const auto run = frames(small_scene());
    BOOST_TEST_REQUIRE(run.size() == 2U * 2 * 4);
    for (std::size_t i = 0; i < run.size(); ++i) {
        const std::int64_t schedule[4] = {0, 10, 20, 25};
        BOOST_TEST(run[i].iteration == schedule[i % 4]);
        BOOST_TEST(run[i].last == (i % 4 == 3));
        BOOST_TEST(run[i].replica == static_cast<int>(i / 4 % 2));
        BOOST_TEST(run[i].angle_index == i / 8);
        BOOST_TEST(run[i].angle == (i < 8 ? 20.0 : 60.0));
        BOOST_TEST(run[i].flow.size() == static_cast<std::size_t>(run[i].iteration));
        BOOST_TEST(run[i].state.size() == run[i].sites);
        BOOST_TEST(run[i].twin.empty());
    }
    BOOST_TEST((run[0].state != run[4].state));  // each replica has its own numbers
}

BOOST_AUTO_TEST_CASE(the_stream_is_the_engine_s_state_bit_for_bit) {
    auto s = small_scene();
    s.reading.sweep = scene::HopperSweep::top_to_bottom;
    s.reading.tie_tolerance = 2e-3;
    s.c_o = 0.003;
    s.random = scene::HopperRandom::shared_stream;
    const auto run = frames(s);
    const auto engine = hopper::make_engine(
        {.outlet = 6,
         .levels = 30,
         .angle = 60,
         .rules = {.c_d = 0.01, .c_o = 0.003, .c_i = 0.1, .c_w = 10, .tie_tolerance = 2e-3},
         .sweep = hopper::Sweep::top_to_bottom,
         .random = hopper::RandomSource::shared_stream,
         .seed = 11,
         .run = 3},
        hopper::EngineKind::plain);
    engine->advance(25);
    BOOST_TEST((run.back().state == engine->state()));
    BOOST_TEST((run.back().flow == engine->record().flow));
    BOOST_TEST(run.back().moves == engine->record().moves);
    BOOST_TEST(run.back().left_reach == engine->record().left_reach);
    BOOST_TEST(run.back().right_reach == engine->record().right_reach);
}

BOOST_AUTO_TEST_CASE(every_choice_of_a_reading_reaches_the_engine) {
    const auto standard = frames(small_scene());
    const auto changed = [&](auto change) {
        auto s = small_scene();
        change(s);
        return frames(s) != standard;
    };
    BOOST_TEST(changed([](auto& s) { s.reading.sweep = scene::HopperSweep::top_to_bottom; }));
    BOOST_TEST(changed([](auto& s) { s.reading.rows = scene::HopperRows::zigzag; }));
    BOOST_TEST(changed([](auto& s) { s.reading.inertia = scene::HopperInertia::literal; }));
    BOOST_TEST(changed([](auto& s) { s.reading.rotation = false; }));
    BOOST_TEST(changed([](auto& s) { s.reading.tie_tolerance = 0.05; }));
    BOOST_TEST(changed([](auto& s) { s.random = scene::HopperRandom::shared_stream; }));
    BOOST_TEST(changed([](auto& s) { s.c_d = 1; }));
    BOOST_TEST(changed([](auto& s) { s.c_o = 0.01; }));
    BOOST_TEST(changed([](auto& s) { s.c_i = 0; }));
    BOOST_TEST(changed([](auto& s) { s.c_w = 0; }));
    BOOST_TEST(changed([](auto& s) { s.seed = 12; }));
    BOOST_TEST(!changed([](auto& s) { s.engine = scene::HopperEngine::plain; }));  // same bits
}

BOOST_AUTO_TEST_CASE(a_twin_starts_with_the_flipped_nodes_and_runs_with_the_same_numbers) {
    auto s = small_scene();
    s.flipped = 3;
    const auto run = frames(s);
    const auto without = frames(small_scene());
    for (std::size_t i = 0; i < run.size(); ++i) {
        BOOST_TEST((run[i].state == without[i].state));
        BOOST_TEST_REQUIRE(run[i].twin.size() == run[i].state.size());
        std::size_t differences = 0;
        for (std::size_t j = 0; j < run[i].state.size(); ++j) {
            differences += run[i].state[j] != run[i].twin[j];
        }
        if (run[i].iteration == 0) BOOST_TEST(differences == 3U);
    }
}

BOOST_AUTO_TEST_CASE(a_kept_dump_has_a_row_per_frame) {
    const tests::TemporaryDirectory directory;
    const auto run = frames(small_scene(), true, directory.path());
    std::ifstream file(directory.path() / "dump.csv");
    std::string line;
    BOOST_REQUIRE(std::getline(file, line));
    BOOST_TEST(line == "angle,replica,iteration,left_the_hopper,left_reach,right_reach,moves");
    std::size_t rows = 0;
    for (; std::getline(file, line); ++rows) {
        const auto& f = run.at(rows);
        std::ostringstream expected;
        expected << f.angle << ',' << f.replica << ',' << f.iteration << ','
                 << std::accumulate(f.flow.begin(), f.flow.end(), 0U) << ',' << f.left_reach << ','
                 << f.right_reach << ',' << f.moves;
        BOOST_TEST(line == expected.str());
    }
    BOOST_TEST(rows == run.size());
}

BOOST_AUTO_TEST_CASE(the_input_is_the_scene_and_changes_with_it) {
    const auto input = code.input(small_scene());
    BOOST_TEST_REQUIRE(input.size() == 1U);
    BOOST_TEST(input[0].name == "scene.json");
    auto other = small_scene();
    other.c_o = 1e-3;
    BOOST_TEST(code.input(other)[0].text != input[0].text);
}

BOOST_AUTO_TEST_CASE(scenes_that_the_engine_refuses_are_not_expressible) {
    BOOST_TEST(code.cannot_express(small_scene()).value_or("") == "");
    auto s = small_scene();
    s.outlet = 1;
    BOOST_TEST(code.cannot_express(s).value_or("").find("outlet") != std::string::npos);
    s = small_scene();
    s.angles.push_back(180);
    BOOST_TEST(code.cannot_express(s).value_or("").find("angle") != std::string::npos);
    s = small_scene();
    s.reading.tie_tolerance = 100;
    BOOST_TEST(code.cannot_express(s).value_or("").find("tie_tolerance") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_run_stops_when_asked_and_when_its_time_is_over) {
    auto s = small_scene();
    s.iterations = 1'000'000'000;
    s.every = s.iterations;
    std::stop_source stop;
    stop.request_stop();
    const auto ignore = [](const scene::HopperFrame&) {};
    BOOST_CHECK_THROW(
        (void)code.run(s, {.directory = {}, .time_limit = 60, .stop = stop.get_token()}, ignore),
        Interrupted);
    BOOST_CHECK_EXCEPTION(
        (void)code.run(s, {.directory = {}, .time_limit = 0.05, .stop = {}}, ignore), AdapterError,
        [](const AdapterError& error) {
            return std::string(error.what()).find("time limit") != std::string::npos;
        });
}
