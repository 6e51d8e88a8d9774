// Protects every number of the models on lattices: frames that are lost, repeated, misshapen or
// that lose particles must never reach an estimator.
#include "cases/scene/lattice_guard.hpp"

#include "native/base/errors.hpp"

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace crossgrain;
using namespace crossgrain::scene;

namespace {

LatticeGas pipe() {
    LatticeGas gas;
    gas.ends = PipeEnds::periodic;
    gas.sampling = {.length = 4,
                    .width = 3,
                    .bin = 2,
                    .replicas = 2,
                    .burn_in = 10,
                    .steps = 20,
                    .every = 10,
                    .fields = {.count = true, .rests = true, .momentum = true}};
    return gas;
}

/// Frames of two bins and two replicas, twelve particles in each replica.
struct Frames {
    std::vector<std::uint16_t> count{5, 4, 7, 8}, rests{1, 1, 1, 1};
    std::vector<std::int16_t> momentum{3, 2, -4, 0};
    std::vector<std::uint8_t> saturated;

    [[nodiscard]] GasFrame at(std::int64_t step) const {
        return {.step = step,
                .bins = 2,
                .replicas = 2,
                .count = count,
                .rests = rests,
                .momentum = momentum,
                .saturated = saturated};
    }
};

HopperAutomaton funnel() {
    HopperAutomaton hopper;
    hopper.angles = {30, 60};
    hopper.replicas = 2;
    hopper.iterations = 5;
    hopper.every = 2;
    return hopper;
}

/// Ten grains, of which one leaves in each iteration.
struct Funnel {
    std::vector<std::uint8_t> state = std::vector<std::uint8_t>(10, 1);
    std::vector<std::uint32_t> flow;

    HopperFrame at(std::size_t angle, int replica, std::int64_t iteration) {
        state.assign(10, 1);
        std::fill_n(state.begin(), iteration, std::uint8_t{0});
        flow.assign(static_cast<std::size_t>(iteration), 1);
        return {.angle_index = angle,
                .replica = replica,
                .iteration = iteration,
                .last = iteration == 5,
                .state = state,
                .flow = flow};
    }
};

}  // namespace

BOOST_AUTO_TEST_CASE(good_frames_of_a_gas_pass) {
    GasFrameGuard guard(pipe());
    Frames frames;
    guard(frames.at(10));
    frames.count = {6, 4, 6, 8};
    guard(frames.at(20));
    BOOST_CHECK_THROW(guard.finish(), TrajectoryError);  // one is still to come
    guard(frames.at(30));
    BOOST_CHECK_NO_THROW(guard.finish());
}

BOOST_AUTO_TEST_CASE(lost_repeated_and_late_frames_are_refused) {
    const Frames frames;
    for (const std::int64_t second : {10, 30, 25}) {
        GasFrameGuard guard(pipe());
        guard(frames.at(10));
        BOOST_CHECK_THROW(guard(frames.at(second)), TrajectoryError);
    }
    GasFrameGuard early(pipe());
    BOOST_CHECK_THROW(early(frames.at(0)), TrajectoryError);
}

BOOST_AUTO_TEST_CASE(a_saturated_pipe_ends_early) {
    GasFrameGuard guard(pipe());
    Frames frames;
    guard(frames.at(10));
    frames.count[0] = 6;
    frames.saturated = {1, 0};
    guard(frames.at(13));
    BOOST_CHECK_NO_THROW(guard.finish());
    BOOST_CHECK_THROW(guard(frames.at(20)), TrajectoryError);
}

BOOST_AUTO_TEST_CASE(particles_that_cannot_be_are_refused) {
    const auto refused = [](auto spoil) {
        GasFrameGuard guard(pipe());
        Frames frames;
        guard(frames.at(10));
        spoil(frames);
        BOOST_CHECK_THROW(guard(frames.at(20)), TrajectoryError);
    };
    refused([](Frames& f) { f.count[0] = 4; });     // one is lost
    refused([](Frames& f) { f.rests[0] = 6; });     // more at rest than there are
    refused([](Frames& f) { f.momentum[0] = 9; });  // four movers carry eight at most
    refused([](Frames& f) { f.count.pop_back(); });
    refused([](Frames& f) { f.rests.clear(); });
    // An open pipe loses and gains particles.
    LatticeGas open = pipe();
    open.ends = PipeEnds::open;
    GasFrameGuard guard(open);
    Frames frames;
    guard(frames.at(10));
    frames.count[0] = 9;
    BOOST_CHECK_NO_THROW(guard(frames.at(20)));
}

BOOST_AUTO_TEST_CASE(replicas_with_one_history_are_refused) {
    Frames frames;
    frames.count = {5, 5, 7, 7};
    frames.momentum = {3, 3, -4, -4};
    GasFrameGuard still(pipe());
    for (const std::int64_t step : {10, 20, 30})
        still(frames.at(step));
    BOOST_CHECK_NO_THROW(still.finish());  // nothing ever happened in either
    GasFrameGuard copies(pipe());
    copies(frames.at(10));
    frames.count = {6, 6, 6, 6};
    copies(frames.at(20));
    copies(frames.at(30));
    BOOST_CHECK_THROW(copies.finish(), TrajectoryError);
}

BOOST_AUTO_TEST_CASE(a_signal_need_not_keep_its_number) {
    SyntheticSignal signal;
    signal.sampling = pipe().sampling;
    signal.sampling.fields = {.count = true};
    GasFrameGuard guard(signal);
    Frames frames;
    frames.rests.clear();
    frames.momentum.clear();
    for (const std::int64_t step : {10, 20, 30}) {
        frames.count[0] = static_cast<std::uint16_t>(frames.count[0] + 3);
        guard(frames.at(step));
    }
    BOOST_CHECK_NO_THROW(guard.finish());
}

BOOST_AUTO_TEST_CASE(good_frames_of_a_hopper_pass) {
    const auto hopper = funnel();
    HopperFrameGuard guard(hopper);
    Funnel frames;
    for (const std::size_t angle : {0U, 1U}) {
        for (const int replica : {0, 1}) {
            BOOST_CHECK_THROW(guard.finish(), TrajectoryError);
            for (const std::int64_t iteration : {0, 2, 4, 5})
                guard(frames.at(angle, replica, iteration));
        }
    }
    BOOST_CHECK_NO_THROW(guard.finish());
}

BOOST_AUTO_TEST_CASE(bad_frames_of_a_hopper_are_refused) {
    const auto hopper = funnel();
    const auto refused = [&](auto spoil) {
        HopperFrameGuard guard(hopper);
        Funnel frames;
        guard(frames.at(0, 0, 0));
        HopperFrame frame = frames.at(0, 0, 2);
        spoil(frames, frame);
        BOOST_CHECK_THROW(guard(frame), TrajectoryError);
    };
    refused([](Funnel& f, HopperFrame&) { f.state[5] = 0; });   // a grain vanishes
    refused([](Funnel& f, HopperFrame&) { f.state[0] = 2; });   // another appears
    refused([](Funnel&, HopperFrame& f) { f.iteration = 4; });  // a frame is lost
    refused([](Funnel&, HopperFrame& f) { f.replica = 1; });
    refused([](Funnel&, HopperFrame& f) { f.last = true; });
    refused([](Funnel&, HopperFrame& f) { f.flow = f.flow.first(1); });
}
