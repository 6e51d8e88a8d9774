// Pictures as PNG files: palette images, so that a colour means what its palette entry says.
#pragma once

#include "cases/measure/results.hpp"

#include <string>

namespace crossgrain::reports {

/// The bytes of a PNG file with the picture's own palette; nothing is resampled or converted.
/// @throws std::invalid_argument when pixels, size and palette do not fit together.
[[nodiscard]] std::string png_bytes(const measure::Picture& picture);

}  // namespace crossgrain::reports
