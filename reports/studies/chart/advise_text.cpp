#include "reports/studies/chart/advise.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace crossgrain::studies {

using nlohmann::json;

namespace {

std::string way(const ChartPoint& point) {
    return point.variant.empty() ? point.code : fmt::format("{} {}", point.code, point.variant);
}

}  // namespace

std::string advice_text(const Advice& advice) {
    std::string text = fmt::format("{} within {:g}:\n", advice.observable, advice.tolerance);
    if (const auto& best = advice.cheapest) {
        text += fmt::format("  enough: {}, {} run{}, {:.3g} CPU s; bias {:.2g} +- {:.1g}, scatter "
                            "of a run {:.2g}\n",
                            way(best->point), best->runs, best->runs == 1 ? "" : "s", best->cpu_s,
                            best->point.bias, best->point.bias_stderr, best->point.scatter);
    } else {
        text += fmt::format("  none: {}\n", advice.reason);
    }
    if (const auto& less = advice.next_cheaper) {
        text += fmt::format("  not enough: {}, {:.3g} CPU s a run: {} {:.2g} +- {:.1g}\n",
                            way(less->point), less->cpu_s,
                            less->wrong ? "off by" : "too uncertain to say, off by",
                            less->point.bias, less->point.bias_stderr);
    }
    for (const auto& d : advice.dropped) {
        text +=
            fmt::format("  without {} ({}): {} (difference {:.2g} +- {:.1g}), costs {:.2g} "
                        "times as much\n",
                        d.drops, d.variant, d.verdict, d.difference, d.half_width, d.cost_ratio);
    }
    return text;
}

namespace {

json point_json(const ChartPoint& point) {
    return {{"code", point.code},
            {"variant", point.variant},
            {"bias", point.bias},
            {"bias_stderr", point.bias_stderr},
            {"scatter", point.scatter}};
}

}  // namespace

json advice_json(const Advice& advice) {
    json result{{"observable", advice.observable},
                {"tolerance", advice.tolerance},
                {"enough", nullptr},
                {"not_enough", nullptr},
                {"dropped", json::array()},
                {"reason", advice.reason}};
    if (const auto& best = advice.cheapest) {
        result["enough"] = point_json(best->point);
        result["enough"].update({{"runs", best->runs}, {"cpu_s", best->cpu_s}});
    }
    if (const auto& less = advice.next_cheaper) {
        result["not_enough"] = point_json(less->point);
        result["not_enough"].update({{"cpu_s", less->cpu_s}, {"wrong", less->wrong}});
    }
    for (const auto& d : advice.dropped) {
        result["dropped"].push_back({{"drops", d.drops},
                                     {"variant", d.variant},
                                     {"difference", d.difference},
                                     {"half_width_95", d.half_width},
                                     {"verdict", d.verdict},
                                     {"cost_ratio", d.cost_ratio}});
    }
    return result;
}

}  // namespace crossgrain::studies
