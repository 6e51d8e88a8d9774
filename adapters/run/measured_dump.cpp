#include "adapters/run/measured_dump.hpp"

#include "adapters/dump/dump_reader.hpp"
#include "adapters/run/frame_measurement.hpp"
#include "adapters/run/preparation.hpp"
#include "cases/scene/frame_guard.hpp"
#include "native/base/errors.hpp"
#include "native/base/printable.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <memory>

namespace crossgrain::run {

measure::Results measure_frames(const catalog::Case& the_case, const scene::Scene& scene,
                                const std::filesystem::path& dump, const scene::FrameSink& passed,
                                const std::stop_token& stop) {
    FrameMeasurement measurement(the_case, scene);
    scene::FrameGuard guard(scene, [&](const scene::Frame& frame) {
        if (stop.stop_requested()) throw Interrupted();
        measurement.add(frame);
        passed(frame);
    });
    adapters::dump::read_dump_file(dump, scene, std::ref(guard), stop);
    guard.finish();
    return measurement.finish();
}

store::RunRecord measure_dump(const catalog::Case& the_case, const GivenDump& dump,
                              const Settings& settings, const std::stop_token& stop) {
    const auto given = std::make_shared<const scene::AnyScene>(
        the_case.scene(dump.variant, dump.rung, settings.seed));
    const auto ready = preparations_in(settings).prepared(given, the_case.time_limit, stop);
    const auto& scene = std::get<scene::Scene>(*ready);
    store::RunRecord record{.case_name = the_case.name,
                            .variant = the_case.variants[dump.variant].name,
                            .rung = dump.rung,
                            .code = printable(dump.name),
                            .version = "read from a dump",
                            .seed = settings.seed,
                            .created = store::utc_now()};
    const std::string file = printable(dump.file.string(), std::string::npos);
    record.settings_json = nlohmann::json{{"dump", file}}.dump();
    try {
        record.results = measure_frames(
            the_case, scene, dump.file, [](const auto&) {}, stop);
        record.status = store::RunStatus::ok;
    } catch (const TrajectoryError& error) {
        record.status = store::RunStatus::run_failed;
        record.reason = fmt::format("{}: {}", file, printable(error.what()));
    }
    return record;
}

}  // namespace crossgrain::run
