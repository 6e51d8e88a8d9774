// The frames of a run are the engine's own states, bit for bit, in the stream and in the kept dump,
// and they are those of the reference integrator.
#include "adapters/dump/dump_reader.hpp"
#include "adapters/native/native_dem_code.hpp"
#include "native/base/errors.hpp"
#include "native/dem/engine.hpp"
#include "tests/support/parity.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

using namespace crossgrain;
using adapters::NativeDemCode;
using tests::KeptFrame;

namespace {

const NativeDemCode code("test");

struct KeptRun {
    std::vector<KeptFrame> frames;
    adapters::RunCost cost;
};

KeptRun run_in(const std::filesystem::path& directory, const scene::Scene& s, bool keep_dump) {
    KeptRun run;
    run.cost =
        code.run(s, {.directory = directory, .time_limit = 60, .stop = {}, .keep_dump = keep_dump},
                 [&](const scene::Frame& frame) { run.frames.emplace_back(frame); });
    return run;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_stream_is_the_engine_s_state_bit_for_bit) {
    // A vibrated bed, translated by hand.
    const auto s = tests::small_bed(5e-4);
    dem::Parameters p{
        .diameter = 2,
        .mass = 1,
        .stiffness = tests::stiffness,
        .damping = tests::damping,
        .gravity = 1,
        .period_x = 12.6,
        .plate_stiffness = tests::stiffness,
        .bottom =
            dem::MovingPlate{.height = 0, .amplitude = 0.5, .omega = 2 * std::numbers::pi / 2},
        .lid = dem::InertialLid{.mass = 5},
        .dt = 5e-4};
    dem::State start{.x = s.initial.x,
                     .y = s.initial.y,
                     .vx = s.initial.vx,
                     .vy = s.initial.vy,
                     .frozen = {},
                     .lid_height = 5.2};
    dem::Engine engine(p, start);
    const auto frames = tests::frames_of(code, s);
    BOOST_TEST_REQUIRE(frames.size() == 11u);
    for (const auto& frame : frames) {
        engine.advance(frame.step - engine.state().step);
        const auto& state = engine.state();
        BOOST_TEST((frame.x == state.x && frame.y == state.y));
        BOOST_TEST((frame.vx == state.vx && frame.vy == state.vy));
        BOOST_TEST_REQUIRE(frame.lid.has_value());
        BOOST_TEST(frame.lid->height == state.lid_height);
        BOOST_TEST(frame.lid->velocity == state.lid_velocity);
        BOOST_TEST(frame.time == static_cast<double>(frame.step) * s.dt);
    }
}

BOOST_AUTO_TEST_CASE(the_first_frame_is_the_initial_state_and_the_last_the_end_of_the_run) {
    const auto s = tests::doubly_periodic_gas(1e-3);
    const auto frames = tests::frames_of(code, s);
    BOOST_TEST(frames.front().step == 0);
    BOOST_TEST((frames.front().x == s.initial.x && frames.front().vy == s.initial.vy));
    BOOST_TEST(frames.back().step == s.steps);
    BOOST_TEST(!frames.back().lid.has_value());
}

BOOST_AUTO_TEST_CASE(frames_further_apart_than_a_block_of_steps_are_the_same) {
    auto s = tests::doubly_periodic_gas(1e-4);
    const auto fine = tests::frames_of(code, s);
    s.frame_every = s.steps;  // 5000 steps without a frame
    const auto coarse = tests::frames_of(code, s);
    BOOST_TEST(coarse.size() == 2u);
    BOOST_TEST((coarse.back().x == fine.back().x && coarse.back().vy == fine.back().vy));
}

BOOST_AUTO_TEST_CASE(runs_are_the_reference_s_for_every_law_and_scheme) {
    for (const auto damping : {scene::Damping::full_vector, scene::Damping::normal_only}) {
        for (const auto clipping :
             {scene::Clipping::none, scene::Clipping::all, scene::Clipping::normal_only}) {
            for (const auto scheme :
                 {scene::Integrator::verlet_half_step, scene::Integrator::verlet_predicted}) {
                auto s = tests::with_law(tests::oblique_pair(1e-3), damping, clipping);
                s.integrator = scheme;
                (void)tests::check_parity(code, s);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(runs_are_the_reference_s_with_plates_lids_obstacles_and_periods) {
    (void)tests::check_parity(code, tests::bounce_on_bottom(scene::PlateContact::centre, 1e-3));
    (void)tests::check_parity(code, tests::bounce_on_bottom(scene::PlateContact::surface, 1e-3));
    (void)tests::check_parity(code, tests::moving_bottom(1e-3));
    (void)tests::check_parity(code, tests::prescribed_lid(1e-3));
    (void)tests::check_parity(code, tests::free_lid_collision(1e-3));
    (void)tests::check_parity(code, tests::frozen_target(1e-3));
    (void)tests::check_parity(code, tests::heavy_small_gas(5e-4));
    (void)tests::check_parity(code, tests::doubly_periodic_gas(5e-4));
}

BOOST_AUTO_TEST_CASE(a_kept_dump_reads_back_to_the_same_bits) {
    for (const auto& s : {tests::small_bed(1e-3), tests::doubly_periodic_gas(1e-3)}) {
        const tests::TemporaryDirectory directory;
        const auto run = run_in(directory.path(), s, true);
        std::vector<KeptFrame> read;
        adapters::dump::read_dump_file(directory.path() / adapters::kept_dump_name, s,
                                       [&](const scene::Frame& f) { read.emplace_back(f); });
        BOOST_TEST(run.frames.size() == 11u);
        BOOST_TEST(tests::largest_difference(run.frames, read) == 0.0);
    }
}

BOOST_AUTO_TEST_CASE(no_dump_is_written_unless_it_is_asked_for) {
    const tests::TemporaryDirectory directory;
    const auto run = run_in(directory.path(), tests::head_on_pair(1e-3), false);
    BOOST_TEST(run.frames.size() == 11u);
    BOOST_TEST(std::filesystem::is_empty(directory.path()));
}

BOOST_AUTO_TEST_CASE(a_dump_that_cannot_be_written_fails_the_run) {
    const auto s = tests::head_on_pair(1e-3);
    const tests::TemporaryDirectory directory;
    BOOST_CHECK_THROW((void)run_in(directory.path() / "missing", s, true), AdapterError);
}

BOOST_AUTO_TEST_CASE(a_dump_that_does_not_fit_the_disk_fails_the_run) {
    if (!std::filesystem::exists("/dev/full")) return;
    const tests::TemporaryDirectory directory;
    std::filesystem::create_symlink("/dev/full", directory.path() / adapters::kept_dump_name);
    // A large dump fails while it is written, a small one when its last bytes are.
    BOOST_CHECK_THROW((void)run_in(directory.path(), tests::small_bed(1e-3), true), AdapterError);
    BOOST_CHECK_THROW((void)run_in(directory.path(), tests::head_on_pair(1e-3), true),
                      AdapterError);
}

BOOST_AUTO_TEST_CASE(a_run_tells_its_cost) {
    const tests::TemporaryDirectory directory;
    const auto cost = run_in(directory.path(), tests::doubly_periodic_gas(1e-4), false).cost;
    BOOST_TEST(cost.cpu_s > 0);
    BOOST_TEST(cost.wall_s > 0);
    // One thread: what it counts twice would show. The clocks tick apart by some microseconds.
    BOOST_TEST(cost.cpu_s <= cost.wall_s + 1e-3);
}
