// The steps that fill a TradeOff once it has its points, its techniques and its baseline; for the
// files that compute trade-offs alone. `points` must not change after fillTables, whose rows point
// into it.
#pragma once

#include <vector>

#include "reports/stats/tradeoff.h"

namespace report {

/// Sets `front` and `uncertain` of every point.
void markFront(std::vector<TradePoint>& points);
/// Does `a` dominate `b`: as fast and as exact by both errors, and better in one?
bool dominates(const TradePoint& a, const TradePoint& b);

/// equalTime and equalError.
void fillTables(TradeOff& tradeOff);
void fitOrders(TradeOff& tradeOff);
void fitExchanges(TradeOff& tradeOff);

}  // namespace report
