// relief merge on hand-made tables, called as functions: the order of rows, missing and repeated cells, and the types
// of values.
#include "merge_tables.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "algorithms/images/temporary_folder.h"

namespace relief::app {
namespace {

using relief::testing::bytesOf;
using relief::testing::faultOf;
using relief::testing::TemporaryFolder;

Json runOf(const std::string& kind = "tracers", const std::string& commit = "0123456789ab",
           const Json& options = {{"rays", 64}, {"seed", "1"}, {"sizes", {8, 16}}}) {
    return {{"kind", kind}, {"commit", commit}, {"options", options}, {"cells", "00112233aabbccdd"}};
}

PartFile fileOf(int number, int of, const Json& run = runOf()) {
    PartFile file;
    file.path = std::to_string(number) + "of" + std::to_string(of) + ".csv";
    file.part.part = number;
    file.part.of = of;
    file.part.run = run;
    return file;
}

// Returns a part as merge.cpp reads it. rows: cells with their row counts, as JSON. table: the header and all rows.
TextPart partOf(int number, int of, const std::string& rows, const std::string& table,
                const Json& more = Json::object()) {
    TextPart part;
    static_cast<PartFile&>(part) = fileOf(number, of);
    part.part.more = {{"rows", Json::parse(rows)}};
    part.part.more.update(more);
    const std::string line = partLine(part.part);
    part.part = parsePartLine(line).value();
    part.text = "# " + line + "\n";
    part.body = part.text.size();
    part.text += table;
    return part;
}

class MergeTablesTest : public ::testing::Test {
  protected:
    std::string merged(const std::vector<TextPart>& parts, const std::string& name) {
        mergeTables(parts, folder_ / name, session_);
        return bytesOf(folder_ / name);
    }
    Json rowsOf(const std::vector<TextPart>& parts) { return Json::parse(merged(parts, "t.json")); }
    // Returns the message of the refusal; no file may be left.
    std::string refusal(const std::vector<TextPart>& parts, const std::string& name = "refused.csv") {
        const std::string text = faultOf([&] { mergeTables(parts, folder_ / name, session_); });
        EXPECT_FALSE(std::filesystem::exists(folder_ / name)) << text;
        return text;
    }

    TemporaryFolder folder_;
    Session session_{Language::English, std::stop_token()};
};

// Cells may be in any order within a part, and parts in any order; the rows of a cell keep theirs.
TEST_F(MergeTablesTest, RowsComeInTheOrderOfTheCells) {
    const TextPart odd = partOf(1, 2, "[[4,1],[0,2],[2,0]]", "name,value\ne,5\na,9\na,1\n");
    const TextPart even = partOf(2, 2, "[[3,1],[1,1]]", "name,value\nd,4\nb,2\n");
    const std::string table = "name,value\na,9\na,1\nb,2\nd,4\ne,5\n";
    EXPECT_EQ(merged({odd, even}, "t.csv"), table);
    EXPECT_EQ(merged({even, odd}, "u.csv"), table);
    EXPECT_EQ(merged({partOf(1, 1, "[[0,1]]", "name,value\na,9\n")}, "one.csv"), "name,value\na,9\n");
}

TEST_F(MergeTablesTest, TablesWithoutRows) {
    const TextPart one = partOf(1, 2, "[[0,0],[2,0]]", "name,value\n"), two = partOf(2, 2, "[[1,0]]", "name,value\n");
    EXPECT_EQ(merged({one, two}, "t.csv"), "name,value\n");
    EXPECT_EQ(merged({one, two}, "t.json"), "[]\n");
    // With more parts than cells some have none.
    EXPECT_EQ(merged({partOf(1, 2, "[[0,1]]", "name,value\na,1\n"), partOf(2, 2, "[]", "name,value\n")}, "u.csv"),
              "name,value\na,1\n");
}

// The whole file, as one process writes it: names in the header's order, indented by one space per level, null for
// missing numbers.
TEST_F(MergeTablesTest, JsonIsThatOfOneProcess) {
    const Json kinds{{"words", {"map"}}, {"reals", {"rate"}}};
    const TextPart one = partOf(1, 2, "[[0,1]]", "map,rays,rate\nhills,7,1.5\n", kinds);
    const TextPart two = partOf(2, 2, "[[1,1]]", "map,rays,rate\n7,,\n", kinds);
    EXPECT_EQ(merged({two, one}, "t.json"),
              "[\n {\n  \"map\": \"hills\",\n  \"rays\": 7,\n  \"rate\": 1.5\n },\n"
              " {\n  \"map\": \"7\",\n  \"rays\": null,\n  \"rate\": null\n }\n]\n");
}

// Values in a column of words stay strings whatever they look like, quoted or not.
TEST_F(MergeTablesTest, WordsStayWords) {
    const Json rows =
        rowsOf({partOf(1, 1, "[[0,9]]", "w\n007\n1e5\n\nnan\ntrue\nnull\n\"a,b\"\n\"say \"\"so\"\"\"\n\"two\nlines\"\n",
                       {{"words", {"w"}}})});
    std::vector<std::string> found;
    for (const Json& row : rows) found.push_back(row.at("w").get<std::string>());
    EXPECT_EQ(found,
              (std::vector<std::string>{"007", "1e5", "", "nan", "true", "null", "a,b", "say \"so\"", "two\nlines"}));
    // In CSV they are copied unchanged.
    EXPECT_EQ(merged({partOf(1, 1, "[[0,2]]", "w,x\n\"two\nlines\",1\n\"a,\"\"b\",2\n")}, "t.csv"),
              "w,x\n\"two\nlines\",1\n\"a,\"\"b\",2\n");
}

// All 17 digits of real numbers; integers beyond the range of double; missing numbers, and words among numbers.
TEST_F(MergeTablesTest, NumbersKeepEveryDigit) {
    const std::string reals = "r\n0.30000000000000004\n60\n-0\n5e-324\n1.7976931348623157e+308\n\nrandom\ninf\n";
    const Json rows = rowsOf({partOf(1, 1, "[[0,8]]", reals, {{"words", {"r"}}, {"reals", {"r"}}})});
    const auto real = [&](std::size_t n) {
        EXPECT_TRUE(rows[n].at("r").is_number_float()) << n << ": " << rows[n].dump();
        return rows[n].at("r").get<double>();
    };
    EXPECT_EQ(real(0), 0.1 + 0.2);
    EXPECT_EQ(real(1), 60);
    EXPECT_EQ(rows[1].dump(), "{\"r\":60.0}");
    EXPECT_TRUE(std::signbit(real(2)));
    EXPECT_EQ(real(3), std::numeric_limits<double>::denorm_min());
    EXPECT_EQ(real(4), std::numeric_limits<double>::max());
    EXPECT_TRUE(rows[5].at("r").is_null());
    EXPECT_EQ(rows[6].at("r"), "random");
    EXPECT_EQ(rows[7].at("r"), "inf");

    const Json whole = rowsOf(
        {partOf(1, 1, "[[0,6]]", "n\n9007199254740993\n18446744073709551615\n-9223372036854775808\n0\n\n\"7\"\n")});
    EXPECT_EQ(whole[0].dump(), "{\"n\":9007199254740993}");
    EXPECT_EQ(whole[1].dump(), "{\"n\":18446744073709551615}");
    EXPECT_EQ(whole[2].dump(), "{\"n\":-9223372036854775808}");
    EXPECT_EQ(whole[3].dump(), "{\"n\":0}");
    EXPECT_TRUE(whole[4].at("n").is_null());
    EXPECT_EQ(whole[5].at("n"), "7") << "a quoted value is a word";
}

// The type of a column may show in a single part: all parts together determine it.
TEST_F(MergeTablesTest, AColumnHasOneKindInAllParts) {
    const TextPart one = partOf(1, 3, "[[0,1]]", "a,b,c\n60,8,8\n");
    const TextPart two = partOf(2, 3, "[[1,1]]", "a,b,c\n25.5,9,9\n", {{"reals", {"a"}}, {"words", Json::array()}});
    const TextPart three = partOf(3, 3, "[[2,1]]", "a,b,c\n7,x,\n", {{"words", {"b"}}});
    const Json rows = rowsOf({one, two, three});
    EXPECT_EQ(rows[0].dump(), R"({"a":60.0,"b":"8","c":8})");
    EXPECT_EQ(rows[1].dump(), R"({"a":25.5,"b":"9","c":9})");
    EXPECT_EQ(rows[2].dump(), R"({"a":7.0,"b":"x","c":null})");
}

TEST_F(MergeTablesTest, ColumnsThatAreAddedAreRefused) {
    const TextPart one = partOf(1, 2, "[[0,1]]", "a,b\n1,2\n");
    for (const std::string header : {"a,b,c", "a", "b,a", "a,b "}) {
        const TextPart other = partOf(2, 2, "[[1,1]]", header + "\n1,2\n");
        EXPECT_EQ(refusal({one, other}),
                  "2of2.csv: belongs to a different run from 1of2.csv: line 2 is " + header + " here but a,b there");
    }
    const std::string damaged = "2of2.csv: is damaged or cut short: line ";
    EXPECT_EQ(refusal({one, partOf(2, 2, "[[1,1]]", "a,b\n1,2,3\n")}), damaged + "3 is invalid");
    EXPECT_EQ(refusal({one, partOf(2, 2, "[[1,2]]", "a,b\n1,2\n1\n")}), damaged + "4 is invalid");
    EXPECT_EQ(refusal({one, partOf(2, 2, "[[1,1]]", "a,b\n1,\"2\n")}), damaged + "3 is invalid") << "a quote left open";
}

TEST_F(MergeTablesTest, WhatIsCutShortIsRefused) {
    const TextPart one = partOf(1, 2, "[[0,1]]", "a,b\n1,2\n");
    const std::string damaged = "2of2.csv: is damaged or cut short: ";
    const auto with = [&](const std::string& rows, const std::string& table) {
        return refusal({one, partOf(2, 2, rows, table)});
    };
    EXPECT_EQ(with("[[1,1]]", ""), damaged + "line 2 is invalid");
    EXPECT_EQ(with("[[1,1]]", "\n"), damaged + "line 2 is invalid");
    EXPECT_EQ(with("[[1,1]]", "a,b"), damaged + "line 2 is invalid");
    EXPECT_EQ(with("[[1,1]]", "a,b\n1,2"), damaged + "line 3 is invalid");
    EXPECT_EQ(with("[[1,2]]", "a,b\n1,2\n3"), damaged + "line 4 is invalid");
    EXPECT_EQ(with("[[1,2]]", "a,b\n1,2\n"), damaged + "the first line announces 2 rows, the file has 1");
    EXPECT_EQ(with("[[1,1]]", "a,b\n1,2\n3,4\n"), damaged + "the first line announces 1 rows, the file has 2");
    EXPECT_EQ(with("[[1,1],[3,1]]", "a,b\n1,2\n"), damaged + "the first line announces 2 rows, the file has 1");
    for (const std::string rows :
         {"7", "null", "{}", "[1]", "[[1]]", "[[1,1,1]]", "[[1,-1]]", "[[-1,1]]", "[[1.5,1]]", "[[1,\"1\"]]"}) {
        EXPECT_EQ(with(rows, "a,b\n1,2\n"), damaged + "line 1 is invalid") << rows;
    }
    // The sum of the row counts overflows.
    EXPECT_EQ(with("[[1,1],[3,18446744073709551615]]", "a,b\n1,2\n").substr(0, damaged.size()), damaged);
}

TEST_F(MergeTablesTest, EveryCellIsThereOnce) {
    const TextPart one = partOf(1, 2, "[[0,1],[2,1]]", "a\n1\n3\n");
    const auto wrong = [](const std::string& path) { return path + ": is damaged or cut short: line 1 is invalid"; };
    EXPECT_EQ(refusal({one, partOf(2, 2, "[]", "a\n")}), wrong("2of2.csv")) << "cell 1 is missing";
    EXPECT_EQ(refusal({one, partOf(2, 2, "[[1,1],[1,1]]", "a\n2\n2\n")}), wrong("2of2.csv")) << "twice";
    EXPECT_EQ(refusal({one, partOf(2, 2, "[[1,1],[2,1]]", "a\n2\n3\n")}), wrong("2of2.csv")) << "another part's";
    EXPECT_EQ(refusal({one, partOf(2, 2, "[[1,1],[5,1]]", "a\n2\n6\n")}), wrong("2of2.csv")) << "cell 3 is missing";
    EXPECT_EQ(refusal({partOf(1, 2, "[[2,1]]", "a\n3\n"), partOf(2, 2, "[[1,1]]", "a\n2\n")}), wrong("1of2.csv"))
        << "cell 0 is missing";
    EXPECT_EQ(merged({one, partOf(2, 2, "[[1,1]]", "a\n2\n")}, "t.csv"), "a\n1\n2\n3\n");
}

TEST_F(MergeTablesTest, TheEndingSaysWhatIsWritten) {
    const TextPart one = partOf(1, 1, "[[0,1]]", "a\n1\n");
    EXPECT_NE(refusal({one}, "t.jsonl").find(".csv"), std::string::npos);
    EXPECT_NE(refusal({one}, "t").find(".json"), std::string::npos);
    EXPECT_EQ(merged({one}, "T.CSV"), "a\n1\n");
    EXPECT_EQ(Json::parse(merged({one}, "T.JSON")).size(), 1U);
}

// --- Which parts make up a run

std::string wholeRunFault(const std::vector<PartFile>& files) {
    return faultOf([&] { requireWholeRun(files); });
}

TEST(MergeParts, AllPartsOfOneRunOnceEach) {
    EXPECT_EQ(wholeRunFault({fileOf(1, 1)}), "");
    EXPECT_EQ(wholeRunFault({fileOf(3, 3), fileOf(1, 3), fileOf(2, 3)}), "");
    EXPECT_EQ(wholeRunFault({fileOf(2, 5), fileOf(4, 5)}), "2of5.csv: is one of 5 parts; missing: 1, 3, 5");
    PartFile again = fileOf(2, 3);
    again.path = "again.csv";
    EXPECT_EQ(wholeRunFault({fileOf(1, 3), fileOf(2, 3), again}), "again.csv: is part 2 of 3, and so is 2of3.csv");
    EXPECT_EQ(wholeRunFault({fileOf(1, 2), fileOf(2, 3)}),
              "2of3.csv: belongs to a different run from 1of2.csv: --part is 2/3 here but 1/2 there");
    // The message lists twenty.
    std::string twenty;
    for (int n = 2; n <= 21; ++n) twenty += std::to_string(n) + ", ";
    EXPECT_EQ(wholeRunFault({fileOf(1, 22)}), "1of22.csv: is one of 22 parts; missing: " + twenty + "...");
    EXPECT_EQ(wholeRunFault({fileOf(1, 21)}),
              "1of21.csv: is one of 21 parts; missing: " + twenty.substr(0, twenty.size() - 2));
}

TEST(MergeParts, PartsOfOtherRunsAreNamedByWhatDiffers) {
    const auto fault = [](const Json& run) { return wholeRunFault({fileOf(1, 2), fileOf(2, 2, run)}); };
    const std::string other = "2of2.csv: belongs to a different run from 1of2.csv: ";
    EXPECT_EQ(fault(runOf()), "");
    EXPECT_EQ(fault(runOf("rows")),
              "2of2.csv: is a part of a different kind from 1of2.csv; only parts of one run can be merged");
    EXPECT_EQ(fault(runOf("tracers", "ba9876543210")),
              other + "commit is \"ba9876543210\" here but \"0123456789ab\" there");
    const auto with = [&](const Json& options) { return fault(runOf("tracers", "0123456789ab", options)); };
    EXPECT_EQ(with({{"rays", 64}, {"seed", "2"}, {"sizes", {8, 16}}}), other + "seed is \"2\" here but \"1\" there");
    EXPECT_EQ(with({{"rays", 64}, {"seed", "1"}, {"sizes", {8, 32}}}), other + "sizes is [8,32] here but [8,16] there");
    EXPECT_EQ(with({{"rays", 65}, {"seed", "2"}, {"sizes", {8}}}), other + "seed is \"2\" here but \"1\" there")
        << "the seed is named first";
    EXPECT_EQ(with({{"seed", "1"}, {"sizes", {8, 16}}}), other + "rays is null here but 64 there");
    EXPECT_EQ(with({{"rays", 64}, {"seed", "1"}, {"sizes", {8, 16}}, {"more", true}}),
              other + "more is true here but null there");
    EXPECT_EQ(with({{"sizes", {8, 16}}, {"seed", "1"}, {"rays", 64}}), "") << "the order of members does not matter";
    Json cells = runOf();
    cells["cells"] = "ffeeddcc99887766";
    EXPECT_EQ(fault(cells), other + "cells is \"ffeeddcc99887766\" here but \"00112233aabbccdd\" there");
}

TEST(MergeParts, DifferencesWithinOptionsHaveTheirPath) {
    const auto run = [](double elevation, const std::string& name) {
        return runOf("render", "0123456789ab", {{"camera", {{"elevation", elevation}, {"fov", 40}}}, {"name", name}});
    };
    EXPECT_FALSE(runDifference(run(20, "a"), run(20, "a")));
    const auto camera = runDifference(run(20, "a"), run(25, "b"));
    ASSERT_TRUE(camera);
    EXPECT_EQ(camera->what, "camera.elevation");
    EXPECT_EQ(camera->here, "20.0");
    EXPECT_EQ(camera->there, "25.0");
    // Long values are truncated to sixty characters.
    const auto name = runDifference(run(20, std::string(100, 'x')), run(20, "b"));
    ASSERT_TRUE(name);
    EXPECT_EQ(name->here, "\"" + std::string(59, 'x') + "...");
}

TEST(MergeParts, PartLinesAreReadBack) {
    Part part = fileOf(2, 3).part;
    part.more = {{"rows", {{1, 4}}}, {"words", {"w"}}};
    const std::string line = partLine(part);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const auto read = parsePartLine(line);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->part, 2);
    EXPECT_EQ(read->of, 3);
    EXPECT_EQ(read->run, part.run);
    EXPECT_EQ(read->more, part.more);
    EXPECT_FALSE(parsePartLine(runLine(part.run))) << "of a whole run";
    for (const char* text : {"", "{}", "[]", "7", "null", "nonsense"}) EXPECT_FALSE(parsePartLine(text)) << text;
    const auto altered = [&](const std::function<void(Json&)>& alter) {
        Json json = Json::parse(line);
        alter(json);
        return parsePartLine(json.dump()).has_value();
    };
    EXPECT_TRUE(altered([](Json&) {}));
    EXPECT_TRUE(altered([](Json& json) { json["relief part"] = 3; }));
    for (const Json& number : {Json(0), Json(4), Json(-1), Json(1.5), Json("2"), Json()}) {
        EXPECT_FALSE(altered([&](Json& json) { json["relief part"] = number; })) << number.dump();
    }
    EXPECT_TRUE(altered([](Json& json) { json["of"] = kMostParts; }));
    EXPECT_FALSE(altered([](Json& json) { json["of"] = kMostParts + 1; }));
    for (const char* name : {"kind", "commit", "options", "cells"}) {
        EXPECT_FALSE(altered([&](Json& json) { json["run"].erase(name); })) << name;
        EXPECT_FALSE(altered([&](Json& json) { json["run"][name] = 7; })) << name;
    }
}

// Bands of a picture: every row once, in order, and their heights differ by one row at most.
TEST(MergeParts, BandsShareTheRows) {
    for (const int height : {1, 2, 7, 61, 1080, 32768}) {
        for (const int of : {1, 2, 3, 5, 7, 61, 1000}) {
            if (of > height) {
                EXPECT_NE(faultOf([&] { partRows({1, of}, height); }), "");
                continue;
            }
            int done = 0;
            for (int part = 1; part <= of; ++part) {
                const RowRange rows = partRows({part, of}, height);
                EXPECT_EQ(rows.begin, done);
                EXPECT_GE(rows.end - rows.begin, height / of);
                EXPECT_LE(rows.end - rows.begin, height / of + 1);
                done = rows.end;
            }
            EXPECT_EQ(done, height);
        }
    }
}

TEST(MergeParts, NumbersOfParts) {
    for (const auto& [text, part, of] :
         {std::tuple("1/1", 1, 1), std::tuple("2/3", 2, 3), std::tuple("100000/100000", 100000, 100000)}) {
        const PartNumber number = parsePartNumber(text);
        EXPECT_EQ(number.part, part);
        EXPECT_EQ(number.of, of);
    }
    for (const char* text :
         {"", "1", "/", "1/", "/2", "0/2", "3/2", "-1/2", "1/2/3", "1.0/2", " 1/2", "1/100001", "a/b"}) {
        EXPECT_NE(faultOf([&] { parsePartNumber(text); }), "") << text;
    }
    std::vector<std::uint64_t> cells;
    for (std::uint64_t n = 0; n < 9; ++n) {
        if (PartNumber{2, 4}.has(n)) cells.push_back(n);
    }
    EXPECT_EQ(cells, (std::vector<std::uint64_t>{1, 5}));
}

}  // namespace
}  // namespace relief::app
