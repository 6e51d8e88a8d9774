#include "cases/measure/gas/gas_wave_number.hpp"

#include "cases/measure/gas/gas_record.hpp"

#include <stdexcept>

namespace crossgrain::measure {

GasWaveNumber::GasWaveNumber(const scene::GasSampling& sampling, GasWaveNumberOptions options)
    : frames_(sampling.frames()),
      factor_(gas_record(sampling).shape,
              {options.k_min, options.k_max == 0 ? sampling.bins() / 4 : options.k_max}) {
    if (!sampling.fields.count) throw std::invalid_argument("the frames have no field \"count\"");
    if (options.fields < 1) throw std::invalid_argument("needs at least one field");
    stride_ = (frames_ + options.fields - 1) / options.fields;
}

void GasWaveNumber::add(const scene::GasFrame& frame) {
    if (!frame.saturated.empty()) return;
    if (frame_++ % stride_ == 0) factor_.add(frame.count);
}

void GasWaveNumber::finish(Results& results) {
    if (frame_ == frames_) factor_.append(results);
}

}  // namespace crossgrain::measure
