// A small complete case file, and how to read variations of it.
#pragma once

#include "cases/catalog/case.hpp"
#include "tests/cases/toml/refusal.hpp"
#include "tests/support/temporary_directory.hpp"

#include <boost/test/unit_test.hpp>

#include <fstream>
#include <string>

namespace crossgrain::tests {

/// Line 1 is the first. A gas, so that another seed is another initial state.
inline const std::string case_text = R"(name = "small"
title = "A small case"
source = "Author, section 1"
text = "What it asks."
suites = ["quick", "full"]
time_limit = 60.0
replicas = { default = 2, lammps = 3 }
[scene]
gravity = 0.0
periodic_x = 20.0
periodic_y = 20.0
integrator = "verlet-half-step"
dt = 1e-3
time = 1.0
frames = { every_time = 0.1 }
grains = { diameter = 2.0, mass = 1.0 }
initial = { kind = "gas", count = 16, velocity_spread = 3.0 }
[scene.contact]
restitution = 0.8
contact_time = 0.1
damping = "full-vector"
clipping = "none"
spins = "off"
[[observable]]
name = "momentum"
[[check]]
kind = "exact"
observable = "momentum_drift_x"
against = "analytic:zero"
limit = 1e-11
reason = "round-off"
)";

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    BOOST_TEST_REQUIRE(at != std::string::npos, "the text has no '" << what << "'");
    return text.replace(at, what.size(), by);
}

inline catalog::Case load(const std::string& text, catalog::Suite suite = catalog::Suite::full) {
    const TemporaryDirectory directory;
    const std::string file = (directory.path() / "small.toml").string();
    std::ofstream(file) << text;
    return catalog::load_case(file, suite);
}

inline CaseErrorDetails refusal_of(const std::string& text,
                                   catalog::Suite suite = catalog::Suite::full) {
    return refusal([&] { (void)load(text, suite); });
}

inline CaseErrorDetails refusal_with(const std::string& what, const std::string& by) {
    return refusal_of(replaced(case_text, what, by));
}

}  // namespace crossgrain::tests
