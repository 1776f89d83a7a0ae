// The steps that fill a TradeOff once it has its points, for tradeoff.cpp alone. Each needs what
// the steps before it filled.
#pragma once

#include <vector>

#include "reports/stats/tradeoff.h"

namespace report {

/// Sets `front` and `uncertain` of every point.
void markFront(std::vector<TradePoint>& points);
/// Does `a` dominate `b`: as fast and as exact, and better in one?
bool dominates(const TradePoint& a, const TradePoint& b);

/// equalTime and equalError.
void fillTables(TradeOff& tradeOff);
void fitOrders(TradeOff& tradeOff);
void fitExchanges(TradeOff& tradeOff);

}  // namespace report
