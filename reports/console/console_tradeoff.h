// The trade-offs between time and error as plain text: what `tradeOffs` found, one block a scene,
// size and device. Times have two decimals as in the table of cells, errors three digits wherever
// they lie.
#pragma once

#include <string>
#include <vector>

#include "reports/stats/tradeoff.h"

namespace report {

/// Points by time, the tables of equal time and equal error, orders and rates of exchange, with
/// what to read them by. Empty for none. Never says "GPU" of a software device.
std::string toTable(const std::vector<TradeOff>& tradeOffs);

}  // namespace report
