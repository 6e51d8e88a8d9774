// The Python scripts with which YADE runs any scene. They stand in scene.py.in, laws.py.in
// and plates.py.in and are put into the library when that is built.
#pragma once

#include <string_view>

namespace crossgrain::adapters::yade {

[[nodiscard]] std::string_view scene_script();

/// Imported by the scene's script: the contact laws.
[[nodiscard]] std::string_view laws_script();

/// Imported by the scene's script when there are plates or backing planes.
[[nodiscard]] std::string_view plates_script();

}  // namespace crossgrain::adapters::yade
