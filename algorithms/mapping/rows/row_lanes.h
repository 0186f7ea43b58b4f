// The SIMD version of streamsRow (row_kernels.h): one stream per lane, by Google Highway, the instruction set chosen
// at run time. Additions and divisions are those of the reference in the same order, so the bits are the same
// on every instruction set; tests force each.
#pragma once

#include <cstdint>
#include <vector>

#include "mapping/rows/row_terms.h"

namespace relief {

// k of which there are lanes: 2, 4, 8, 16, 32.
bool hasStreamLanes(std::int64_t k);

// Requires hasStreamLanes(k), row.anchor a multiple of k or 0, row.count > 0.
// pastCache: non-temporal stores where u and v are aligned to 64 bytes (else ignored); ended by finishStores().
void streamsRowLanes(const RowTerms<float>& row, std::int64_t k, bool pastCache, float* u, float* v);
void streamsRowLanes(const RowTerms<double>& row, std::int64_t k, bool pastCache, double* u, double* v);

// Makes stores past the cache visible to other threads.
void finishStores();

// Writes `value` to count elements, past the cache: the yardstick of `relief bench rows`.
void fillPastCache(float* to, std::int64_t count, float value);
void fillPastCache(double* to, std::int64_t count, double value);

// Instruction sets of this program that this machine can run, best first, as Highway's bits, and their names; forcing
// one is for tests and for a whole process. 0 gives the choice back.
std::vector<std::int64_t> laneTargets();
const char* laneTargetName(std::int64_t target);
void forceLaneTarget(std::int64_t target);

}  // namespace relief
