// All that a key of a scene may say, for sweeps over everything there is.
#pragma once

#include <string>
#include <vector>

namespace crossgrain::scene {

/// The words of a choice of [scene] for grains ("integrator", "precision", "contacts"), in their
/// order; empty for any other key.
[[nodiscard]] std::vector<std::string> words_of(const std::string& key);

}  // namespace crossgrain::scene
