// What the five papers claim, a line each, and what was measured of it.
//
// [MIP18], [DIST17], [PERSP], [TEX] (which repeats [ANISO17]): algorithms/notation.md. Counts of operations, steps and
// errors decide where they can: they are the same on every machine; a rate stands with its spread and its error, both
// sides of it in the same form. Sentences: messages.def.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "relief/messages.h"
#include "relief/work.h"

namespace relief {

// Depends: true for some of what was measured, or only under a condition that the measurement names.
enum class ClaimVerdict : std::uint8_t { Confirmed, Refuted, Depends };

struct Claim {
    std::string_view id;     // in files
    std::string_view paper;  // "[MIP18]"
    Message place;           // in it
    MessageId sentence{};    // what it says
    MessageId found{};       // what was measured, with values
};
// In the order of the papers.
const std::vector<Claim>& paperClaims();

struct MeasuredClaim {
    std::string id;
    ClaimVerdict verdict{};
    std::vector<MessageValue> values;  // of Claim::found
};

struct ClaimsTable {
    std::string date;  // YYYY-MM-DD
    std::string cpu, compiler, commit;
    int size = 0;           // texels along each side of the reliefs
    std::int64_t rays = 0;  // over each
    std::vector<MeasuredClaim> claims;
};

struct ClaimsOptions {
    int size = 128;             // 16 to 1024
    std::int64_t rays = 20000;  // over each relief, 100 and more
    int rounds = 5;             // of what is timed
};
// Six procedural reliefs (seed 1), relief depth 0.2, bilinear, repeat. Some minutes. Throws Cancelled.
ClaimsTable measureClaims(const ClaimsOptions& options, Work& work);

// The table that is part of the program.
const ClaimsTable& shippedClaims();

// A line a claim: paper and place | sentence | measured | verdict; before them two lines with machine and date.
std::string claimsText(const ClaimsTable& table, Language language);
// An object with the numbers, "\n" at the end; parseClaims() reads it back. Throws InputError: no such table.
std::string claimsJson(const ClaimsTable& table);
ClaimsTable parseClaims(const std::string& text, const std::string& fileName);

}  // namespace relief
