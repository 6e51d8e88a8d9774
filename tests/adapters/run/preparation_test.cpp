// A prepared state is made once, without contacts, the same for all codes, and never half.
#include "adapters/run/preparation.hpp"
#include "cases/scene/initial_state.hpp"
#include "cases/scene/preparation.hpp"
#include "native/base/errors.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

namespace tt = boost::test_tools;
using namespace crossgrain;
using run::Preparations;
using scene::Scene;

namespace {

/// An engine that lets everything that moves sink by a little, into what lies below.
class SinkingEngine final : public adapters::GrainCode {
  public:
    [[nodiscard]] std::string name() const override { return "sinking"; }
    [[nodiscard]] adapters::Availability probe(std::stop_token = {}) const override {
        return {.installed = true};
    }
    [[nodiscard]] std::vector<std::string> features() const override { return {}; }
    [[nodiscard]] std::optional<std::string> cannot_express(const Scene&) const override {
        return refusal;
    }
    [[nodiscard]] std::vector<adapters::InputFile> input(const Scene&) const override { return {}; }
    adapters::RunCost run(const Scene& scene, const adapters::RunOptions& options,
                          const Sink& sink) const override {
        ++runs;
        BOOST_TEST(std::filesystem::is_directory(options.directory));
        BOOST_TEST(!scene.preparation.has_value());
        if (options.stop.stop_requested()) throw Interrupted();
        scene::InitialState s = scene.initial;
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            if (!s.frozen[i]) s.y[i] -= 0.03;
        }
        sink({.step = 0, .x = scene.initial.x, .y = scene.initial.y, .vx = s.vx, .vy = s.vy});
        sink({.step = scene.steps, .x = s.x, .y = s.y, .vx = s.vx, .vy = s.vy});
        return {};
    }

    mutable int runs = 0;
    std::optional<std::string> refusal;
};

std::shared_ptr<const scene::AnyScene> settled_scene(std::uint64_t seed = 1) {
    auto s = tests::empty_scene("settled", 1e-3, 1.0);
    s.grains = {.diameter = 1.0, .mass = 1.0};
    s.seed = seed;
    const scene::Settled recipe{
        .hopper = {.angle = 40, .outlet = 4, .height = 6, .settled_fraction = 0.8},
        .settle_time = 2};
    scene::generate_initial_state(s, recipe, {.spread = 0.2});
    return std::make_shared<const scene::AnyScene>(std::move(s));
}

const Scene& grains(const std::shared_ptr<const scene::AnyScene>& any) {
    return std::get<Scene>(*any);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_plug_is_gone_and_nothing_touches) {
    const tests::TemporaryDirectory directory;
    const SinkingEngine engine;
    run::Preparations preparations(directory.path() / "prepared", engine, "1",
                                   run::silent_monitor());
    const auto given = settled_scene();
    const auto ready = preparations.prepared(given, 60, {});
    const auto& before = grains(given);
    const auto& after = grains(ready);
    BOOST_TEST(!after.preparation.has_value());
    // The plug's four discs, and walls above the grains.
    BOOST_TEST(before.grain_count() - after.grain_count() > 4u);
    double highest = 0, top = 0;
    for (std::size_t i = 0; i < after.grain_count(); ++i) {
        double& height = after.initial.frozen[i] ? top : highest;
        height = std::max(height, after.initial.y[i]);
        BOOST_TEST((after.initial.y[i] > 0 || std::abs(after.initial.x[i]) >= 2.5));
    }
    BOOST_TEST((top > highest - 1.0 && top < highest + 1.1));
    BOOST_TEST(after.grains.diameters.size() == after.grain_count());
    BOOST_TEST(after.initial.frozen.size() == after.grain_count());
    BOOST_TEST(scene::initial_contacts(after) == 0u);
    // The grains that move come first: their order and sizes are unchanged.
    BOOST_TEST(after.grains.diameters[3] == before.grains.diameters[3]);
    const double factor = after.initial.y[3] / (before.initial.y[3] - 0.03);
    BOOST_TEST(factor >= 1.0);
    BOOST_TEST(factor < 1.1);
    BOOST_TEST(after.initial.x[3] == before.initial.x[3] * factor, tt::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_state_is_made_once_and_read_back_to_the_same_bits) {
    const tests::TemporaryDirectory directory;
    const SinkingEngine engine;
    run::Preparations preparations(directory.path() / "prepared", engine, "1",
                                   run::silent_monitor());
    const auto first = preparations.prepared(settled_scene(), 60, {});
    run::Preparations later(directory.path() / "prepared", engine, "1", run::silent_monitor());
    const auto again = later.prepared(settled_scene(), 60, {});
    BOOST_TEST(engine.runs == 1);
    BOOST_TEST(grains(first).initial.x == grains(again).initial.x, tt::per_element());
    BOOST_TEST(grains(first).initial.y == grains(again).initial.y, tt::per_element());
    // How long the run itself lasts does not matter; the seed and the engine's version do.
    Scene longer = grains(settled_scene());
    longer.name = "another";
    longer.steps *= 3;
    (void)later.prepared(std::make_shared<const scene::AnyScene>(longer), 60, {});
    BOOST_TEST(engine.runs == 1);
    (void)later.prepared(settled_scene(2), 60, {});
    BOOST_TEST(engine.runs == 2);
    run::Preparations newer(directory.path() / "prepared", engine, "2", run::silent_monitor());
    (void)newer.prepared(settled_scene(), 60, {});
    BOOST_TEST(engine.runs == 3);
}

BOOST_AUTO_TEST_CASE(a_damaged_state_is_made_again) {
    const tests::TemporaryDirectory directory;
    const auto prepared = directory.path() / "prepared";
    const SinkingEngine engine;
    const auto whole = run::Preparations(prepared, engine, "1", run::silent_monitor())
                           .prepared(settled_scene(), 60, {});
    std::filesystem::path file;
    for (const auto& entry : std::filesystem::directory_iterator(prepared))
        if (entry.path().extension() == ".json") file = entry.path();
    std::ifstream in(file);
    const std::string good(std::istreambuf_iterator<char>(in), {});
    const auto without_first_x = [&] {
        const auto begin = good.find("\"x\":[") + 5;
        return good.substr(0, begin) + good.substr(good.find(',', begin) + 1);
    };
    const auto infinite = [&] {
        const auto begin = good.find("\"x\":[") + 5;
        return good.substr(0, begin) + "1e999" + good.substr(good.find(',', begin));
    };
    const auto a_word = [&] {
        const auto begin = good.find("\"y\":[") + 5;
        return good.substr(0, begin) + "\"1\"" + good.substr(good.find(',', begin));
    };
    int made = 1;
    for (const std::string& damaged :
         {std::string(), good.substr(0, good.size() / 2), std::string("[]"), std::string("{}"),
          std::string(200'000, '['), without_first_x(), infinite(), a_word(),
          std::string("{\"x\":null,\"y\":null}")}) {
        std::ofstream(file) << damaged;
        const auto again = run::Preparations(prepared, engine, "1", run::silent_monitor())
                               .prepared(settled_scene(), 60, {});
        BOOST_TEST(engine.runs == ++made, damaged.substr(0, 40));
        BOOST_TEST(grains(again).initial.x == grains(whole).initial.x, tt::per_element());
    }
    // The one that was made last is whole again.
    (void)run::Preparations(prepared, engine, "1", run::silent_monitor())
        .prepared(settled_scene(), 60, {});
    BOOST_TEST(engine.runs == made);
}

BOOST_AUTO_TEST_CASE(a_scene_that_needs_nothing_is_left_alone) {
    const tests::TemporaryDirectory directory;
    const SinkingEngine engine;
    run::Preparations preparations(directory.path() / "prepared", engine, "1",
                                   run::silent_monitor());
    const auto given = std::make_shared<const scene::AnyScene>(tests::small_gas());
    BOOST_TEST(preparations.prepared(given, 60, {}) == given);
    BOOST_TEST(engine.runs == 0);
}

BOOST_AUTO_TEST_CASE(what_was_not_finished_is_not_kept) {
    const tests::TemporaryDirectory directory;
    SinkingEngine engine;
    run::Preparations preparations(directory.path() / "prepared", engine, "1",
                                   run::silent_monitor());
    std::stop_source stop;
    stop.request_stop();
    BOOST_CHECK_THROW((void)preparations.prepared(settled_scene(), 60, stop.get_token()),
                      Interrupted);
    (void)preparations.prepared(settled_scene(), 60, {});
    BOOST_TEST(engine.runs == 2);
    engine.refusal = "no rotating discs";
    BOOST_CHECK_EXCEPTION((void)preparations.prepared(settled_scene(2), 60, {}), AdapterError,
                          [](const AdapterError& error) {
                              return error.details().reason.find("no rotating discs") !=
                                     std::string::npos;
                          });
}

BOOST_AUTO_TEST_CASE(dilation_is_that_of_the_deepest_contact) {
    auto s = tests::empty_scene("overlaps", 1e-3, 1.0);
    tests::add_grain(s, 0, 0, 0, 0);
    tests::add_grain(s, 1.9, 0, 0, 0);
    tests::add_grain(s, 0, 1.6, 0, 0);
    tests::add_grain(s, 9, 9, 0, 0);
    BOOST_TEST(scene::contact_free_dilation(s) == 1.25, tt::tolerance(1e-8));
    s.initial.frozen = {true, false, true, false};
    BOOST_TEST(scene::contact_free_dilation(s) == 2 / 1.9, tt::tolerance(1e-8));
    s.initial.frozen = {true, true, true, true};
    BOOST_TEST(scene::contact_free_dilation(s) == 1.0);
}
