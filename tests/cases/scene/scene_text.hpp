// A small complete [scene] table and how to read variations of it.
#pragma once

#include "cases/scene/scene_file.hpp"
#include "tests/cases/toml/refusal.hpp"

#include <boost/test/unit_test.hpp>

#include <cstdint>
#include <string>

namespace crossgrain::tests {

/// Two explicit grains between plates. Line 1 is the first; replaced() keeps the line numbers.
inline const std::string scene_text = R"(gravity = 1.0
periodic_x = 40.0
integrator = "verlet-half-step"
dt = 0.001
time = 2.0
frames = { every_time = 0.1 }
grains = { diameter = 2.0, mass = 1.0 }
[contact]
restitution = 0.8
contact_time = 0.1
damping = "full-vector"
clipping = "none"
spins = "off"
[plates]
touch = "centre"
bottom = { height = 0.0, amplitude = 0.5, period = 2.0 }
lid = { mass = 5.0, height = 20.0, velocity = -1.0 }
[initial]
kind = "explicit"
x = [1.0, 4.0]
y = [5.0, 6.0]
vx = [0.5, 0.0]
vy = [0.0, 0.25]
)";

/// The text with the one place of `what` replaced.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    BOOST_TEST_REQUIRE(at != std::string::npos, "the text has no '" << what << "'");
    return text.replace(at, what.size(), by);
}

/// The scene's text with another [initial] table and without plates.
inline std::string with_initial(const std::string& initial, const std::string& top = "") {
    return top + scene_text.substr(0, scene_text.find("[plates]")) + "[initial]\n" + initial;
}

inline scene::Scene read_scene(const std::string& text, std::uint64_t seed = 1,
                               std::size_t rung = 0) {
    const toml::table root = toml::parse(text);
    return scene::read_scene(toml_input::TomlTable("case.toml", "scene", {&root}),
                             {.name = "test", .rung = rung, .seed = seed});
}

/// Why the scene's text is refused after `what` is replaced by `by`.
inline CaseErrorDetails refusal_with(const std::string& what, const std::string& by) {
    return refusal([&] { (void)read_scene(replaced(scene_text, what, by)); });
}

/// Holds the key, the line and the problem of a refusal against what is expected.
inline void check_refusal(const CaseErrorDetails& e, const std::string& key, int line,
                          const std::string& problem) {
    BOOST_TEST_CONTEXT("refusal of " << key) {
        BOOST_TEST(e.file == "case.toml");
        BOOST_TEST(e.key == "scene." + key);
        BOOST_TEST(e.line == line);
        BOOST_TEST(e.column > 0);
        BOOST_TEST(e.problem == problem);
    }
}

}  // namespace crossgrain::tests
