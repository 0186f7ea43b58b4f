// The SIMD version of streamsRow (row_kernels.h): one stream per lane, by Google Highway, with the instruction set
// chosen at run time. Additions and divisions are those of the reference in the same order, so the bits are the same on
// every instruction set; tests force each.
#pragma once

#include <cstdint>
#include <vector>

#include "mapping/rows/row_terms.h"

namespace relief {

// Returns true for the numbers of streams k that have a SIMD version: 2, 4, 8, 16, 32.
bool hasStreamLanes(std::int64_t k);

// Evaluates the row into u and v. Requires hasStreamLanes(k), row.anchor a multiple of k or 0, row.count > 0.
// pastCache: use non-temporal stores if u and v are aligned to 64 bytes (otherwise ignored); call finishStores()
// afterwards.
void streamsRowLanes(const RowTerms<float>& row, std::int64_t k, bool pastCache, float* u, float* v);
void streamsRowLanes(const RowTerms<double>& row, std::int64_t k, bool pastCache, double* u, double* v);

// Makes non-temporal stores visible to other threads.
void finishStores();

// Writes `value` to count elements by non-temporal stores: the baseline of `relief bench rows`.
void fillPastCache(float* to, std::int64_t count, float value);
void fillPastCache(double* to, std::int64_t count, double value);

// The compiled instruction sets that this machine can run, best first, as Highway's bits, and their names. Forcing one
// affects the whole process and is meant for tests; 0 restores the automatic choice.
std::vector<std::int64_t> laneTargets();
const char* laneTargetName(std::int64_t target);
void forceLaneTarget(std::int64_t target);

}  // namespace relief
