// Measurements that are means over the replicas of one run of a hopper.
#pragma once

#include "cases/measure/results.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <string>

namespace crossgrain::measure {

/// Appends mean and standard error over the replicas. Nothing for fewer than two: one replica has
/// no error that could be stated.
void append_replica_mean(Results& results, const std::string& observable,
                         std::span<const double> samples, const std::string& unit = "1",
                         const std::map<std::string, double>& settings = {});

/// Appends the share of replicas for which something holds. Its error is that of a binomial share
/// with one success and one failure added (Agresti & Coull, Am. Stat. 52, 119 (1998)), so that it
/// does not vanish at 0 and 1. Nothing without replicas.
void append_share(Results& results, const std::string& observable, std::size_t holds,
                  std::size_t replicas, const std::map<std::string, double>& settings = {});

}  // namespace crossgrain::measure
