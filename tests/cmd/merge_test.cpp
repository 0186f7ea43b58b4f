// Parts of one run (--part K/N) and relief merge: the result is what one process would have written; parts that do not
// belong together are refused, naming the file.
#include <cstdlib>
#include <regex>

#include <nlohmann/json.hpp>

#include "command_test.h"

namespace relief::test {

using Json = nlohmann::ordered_json;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
    return text;
}

// Returns the part line that `bench` writes into a table, with this seed.
std::string partLine(int part, int of, const std::string& rows, const std::string& seed) {
    const Json line{{"relief part", part},
                    {"of", of},
                    {"run",
                     {{"kind", "tracers"},
                      {"commit", "0123456789ab"},
                      {"options", {{"rays", 64}, {"seed", seed}}},
                      {"cells", "00112233aabbccdd"}}},
                    {"rows", Json::parse(rows)},
                    {"words", {"method"}}};
    return "# " + line.dump() + "\n";
}

}  // namespace

class MergeTest : public CommandTest {
  protected:
    std::string size_ = "90x61";  // of pictures
    static constexpr const char* kHeader = "height,method,elevation,rate\n";

    std::vector<std::string> render(const std::string& output, const std::vector<std::string>& more) const {
        std::vector<std::string> all{"render", "--relief", "bricks:48x32", "--size", size_, "-o", path(output)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    // Renders all parts of a picture; returns their files in descending order.
    std::vector<std::string> rendered(int of, const std::string& ending, const std::vector<std::string>& look) const {
        std::vector<std::string> names;
        for (int part = of; part >= 1; --part) {
            auto more = look;
            more.insert(more.end(), {"--part", std::to_string(part) + "/" + std::to_string(of)});
            names.push_back("p" + std::to_string(part) + "of" + std::to_string(of) + ending);
            runFine(render(names.back(), more));
            names.back() = path(names.back());
        }
        return names;
    }
    std::vector<std::string> merge(std::vector<std::string> files, const std::string& output) const {
        files.insert(files.begin(), "merge");
        if (!output.empty()) files.insert(files.end(), {"-o", path(output)});
        return files;
    }
    std::vector<std::string> stress(const std::string& record, const std::vector<std::string>& more) const {
        std::vector<std::string> all{"stress",
                                     "--cases",
                                     "8",
                                     "--seed",
                                     "7",
                                     "--tracers",
                                     "exact,layers:layers=3",
                                     "--parts",
                                     "tracers,homographies",
                                     "--record",
                                     path(record)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    // Runs all parts of a small stress run; returns their records.
    std::vector<std::string> stressed(int of) const {
        std::vector<std::string> names;
        for (int part = 1; part <= of; ++part) {
            const std::string name = "s" + std::to_string(part) + ".jsonl";
            runFine(stress(name, {"--part", std::to_string(part) + "/" + std::to_string(of)}));
            names.push_back(path(name));
        }
        return names;
    }
    // Makes every case of the record report the same kind of violation.
    void violate(const std::string& name) const {
        std::string text;
        for (const std::string& line : lines(read(name))) {
            Json json = Json::parse(line);
            if (json.contains("case")) {
                json["violations"] = 2;
                json["listed"] = {{{"kind", "tracers exact bits"},
                                   {"check", "bits"},
                                   {"detail", "case " + json["case"].dump()},
                                   {"method", "exact"},
                                   {"rays", "at-limit"},
                                   {"map", "noise"},
                                   {"command", "none"}}};
            }
            text += json.dump() + "\n";
        }
        write(name, text);
    }
    // Writes two parts of a table of four cells; the third cell has no row.
    std::vector<std::string> tables() const {
        return {write("odd.csv", partLine(1, 2, "[[0,2],[2,0]]", "1") + kHeader + "\"a,b\",7,60,1.5\n\"a,b\",8,60,\n"),
                write("even.csv", partLine(2, 2, "[[1,1],[3,1]]", "1") + kHeader + "c,9,random,2\nd,10,25,3e-05\n")};
    }
};
INSTANTIATE_TEST_SUITE_P(Places, MergeTest, testing::ValuesIn(places()), placeName);

// Also with violations: each part keeps the first of a kind; together they are more than may be listed.
TEST_P(MergeTest, PartsOfAStressTestMakeTheReportOfOneProcess) {
    const std::string whole = runFine(stress("whole.jsonl", {}));
    const std::vector<std::string> parts = stressed(3);
    EXPECT_EQ(runFine(merge({parts[2], parts[0], parts[1]}, "merged.jsonl")),
              std::regex_replace(whole, std::regex(" in [0-9.e+-]+ s;"), ";"));
    EXPECT_EQ(read("merged.jsonl"), read("whole.jsonl"));
    EXPECT_EQ(lines(read("whole.jsonl")).size(), 9U) << "the run, and eight cases";
    const std::string third = read("s3.jsonl");
    EXPECT_EQ(lines(third).size(), 3U) << "cases 2 and 5";
    const auto refuse = [&](const std::string& text, const std::string& words) {
        write("bad.jsonl", text);
        expectRefusal(merge({parts[0], path("bad.jsonl"), parts[1]}, "m.jsonl"), 2, {path("bad.jsonl") + ": ", words});
        EXPECT_FALSE(std::filesystem::exists(path("m.jsonl")));
    };
    refuse(third.substr(0, third.size() - 1), "line 3");
    refuse(replaced(third, "\"case\":2", "\"case\":5"), "line 2");
    refuse(replaced(third, "\"seed\":7", "\"seed\":8"), "seed is 8 here but 7 there");
    for (const std::string name : {"s1.jsonl", "s2.jsonl", "s3.jsonl"}) violate(name);
    const Result result = run(merge(parts, ""));
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "relief: violations: 16\n");
    EXPECT_NE(result.out.find("violations: 16\n"), std::string::npos) << result.out;
    std::vector<std::string> listed;
    for (const std::string& line : lines(result.out)) {
        if (line.starts_with("violation: ")) listed.push_back(line.substr(line.find("case "), 6));
    }
    EXPECT_EQ(listed, (std::vector<std::string>{"case 0", "case 1", "case 2", "case 3", "case 4"}));
}

TEST_P(MergeTest, BandsMakeTheWholePicture) {
    // The grid filter uses hits above and below the band; bands end at tile rows.
    size_ = "24x160";
    const std::vector<std::string> look{"--filter",  "elliptical-visible", "--filter-set", "form=grid",
                                        "--shadows", "--no-skip",          "--camera",     "elevation=20"};
    runFine(render("whole.png", look));
    const auto parts = rendered(5, ".png", look);
    runFine(merge(parts, "merged.png"));
    EXPECT_TRUE(read("merged.png") == read("whole.png"));
    size_ = "90x61";
    // Pixels use samples of neighbouring rows, which for the upper half are in the next row of tiles.
    const std::vector<std::string> samples{"--supersample", "2", "--pixel-model", "gaussian"};
    runFine(render("whole.png", samples));
    const auto halves = rendered(2, ".png", samples);
    runFine(merge(halves, "merged.png"));
    EXPECT_TRUE(read("merged.png") == read("whole.png"));
    // Parts that do not belong together.
    const auto refuse = [&](const std::vector<std::string>& files, const std::vector<std::string>& words) {
        expectRefusal(merge(files, "m.png"), 2, words);
        EXPECT_FALSE(std::filesystem::exists(path("m.png")));
    };
    refuse({parts[0], parts[1], parts[3], parts[4]}, {parts[0], "missing: 3"});
    refuse({halves[0], parts[4]}, {parts[4], halves[0], "is \""});
    refuse({halves[0], path("whole.png")}, {path("whole.png"), "not a part"});
    const std::string bytes = read("p1of2.png");
    refuse({halves[0], write("cut.png", bytes.substr(0, bytes.size() - 30))}, {path("cut.png")});
    expectRefusal(merge(halves, "m.exr"), 2, {path("m.exr"), ".png"});
    expectRefusal(render("p.jpg", {"--part", "1/2"}), 2, {path("p.jpg"), ".png"});
    expectRefusal(render("p.png", {"--part", "1/2", "--report", "-"}), 2, {"--report", "--part"});
    expectRefusal(render("p.png", {"--part", "1/62"}), 2, {"--part", "62", "61"});
}

TEST_P(MergeTest, BandsOfTiffAndOfLayers) {
    runFine(render("whole.tif", {}));
    runFine(merge(rendered(1, ".tif", {}), "merged.tif"));
    EXPECT_TRUE(withoutDate(read("merged.tif")) == withoutDate(read("whole.tif")));
    const std::vector<std::string> layers{"--layers", "color,depth,uv,normal,steps,outcome,error,footprint,hidden",
                                          "--filter", "elliptical-visible"};
    runFine(render("whole.exr", layers));
    const auto parts = rendered(2, ".exr", layers);
    runFine(merge(parts, "merged.exr"));
    EXPECT_TRUE(withoutDate(read("merged.exr")) == withoutDate(read("whole.exr")));
    const std::string bytes = read("p1of2.exr");
    expectRefusal(merge({parts[0], write("cut.exr", bytes.substr(0, bytes.size() / 2))}, "m.exr"), 2,
                  {path("cut.exr")});
}

TEST_P(MergeTest, PartsOfManyPicturesAreEachNth) {
    runFine(render("parts", {"--to", "elevation=60", "--frames", "4", "--part", "1/3"}));
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path("parts"))) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"frame_00000.png", "frame_00003.png"}));
}

TEST_P(MergeTest, TablesGetTheirRowsInTheOrderOfTheCells) {
    const auto parts = tables();
    runFine(merge({parts[1], parts[0]}, "t.csv"));
    EXPECT_EQ(read("t.csv"), std::string(kHeader) + "\"a,b\",7,60,1.5\n\"a,b\",8,60,\nc,9,random,2\nd,10,25,3e-05\n");
    runFine(merge(parts, "t.json"));
    const Json rows = Json::parse(read("t.json"));
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[0].dump(), R"({"height":"a,b","method":"7","elevation":60,"rate":1.5})");
    EXPECT_EQ(rows[1]["rate"], nullptr);
    EXPECT_EQ(rows[2]["elevation"], "random");
    EXPECT_EQ(rows[3]["rate"], 3e-05);
    const std::string odd = read("odd.csv");
    const auto refuse = [&](const std::string& text, const std::string& words) {
        write("bad.csv", text);
        expectRefusal(merge({path("bad.csv"), parts[1]}, "bad2.csv"), 2, {path("bad.csv"), words});
        EXPECT_FALSE(std::filesystem::exists(path("bad2.csv")));
    };
    refuse(odd.substr(0, odd.size() - 1), "line 4");
    refuse(odd.substr(0, odd.find("\n\"a,b\",8") + 1), "announces 2 rows, the file has 1");
    refuse(replaced(odd, "[[0,2],[2,0]]", "[[2,2]]"), "line 1");
    refuse(replaced(odd, "height,method", "height,form"), "line 2");
}

// Four cells in three parts, one of which has two; with seven parts three have none.
TEST_P(MergeTest, PartsOfASweepMakeItsTable) {
    const auto bench = [&](const std::string& output, const std::vector<std::string>& more) {
        std::vector<std::string> all{"bench",    "rows",         "--widths",  "100,200",    "--elevations",
                                     "60,25",    "--precisions", "float",     "--variants", "direct,streams",
                                     "--pixels", "1000",         "--rounds",  "1",          "--threads",
                                     "1",        "-o",           path(output)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    // Without rate, spread and concurrent, which is unknown for a part.
    const auto rowsOf = [&](const std::string& name) {
        std::vector<std::vector<std::string>> rows;
        for (const std::string& line : lines(read(name))) {
            rows.push_back(fields(line));
            for (const std::size_t column : {11U, 12U}) rows.back().at(column) = "";
            rows.back().back() = "";
        }
        return rows;
    };
    runFine(bench("whole.csv", {}));
    const auto whole = rowsOf("whole.csv");
    ASSERT_EQ(whole.size(), 1U + 2 * 2 * 2);
    for (const int of : {3, 7}) {
        std::vector<std::string> files;
        for (int part = of; part >= 1; --part) {
            const std::string name = std::to_string(part) + "of" + std::to_string(of) + ".csv";
            runFine(bench(name, {"--part", std::to_string(part) + "/" + std::to_string(of)}));
            files.push_back(path(name));
        }
        runFine(merge(files, "merged.csv"));
        EXPECT_EQ(rowsOf("merged.csv"), whole) << of;
    }
    expectRefusal(merge({path("1of3.csv"), path("2of3.csv"), path("3of3.csv")}, "1of3.csv"), 2,
                  {"--output", "1of3.csv"});
    expectRefusal(merge({path("1of3.csv"), path("whole.csv")}, "m.csv"), 2, {"whole.csv", "not a part"});
    expectRefusal(bench("p.json", {"--part", "1/2"}), 2, {"p.json", ".csv"});
    expectRefusal(bench("p.csv", {"--concurrent", "2"}), 2, {"--concurrent", "--part"});
}

// Columns of real numbers, integers, words, and of both, which shows in only one of the parts.
TEST_P(MergeTest, PartsMakeTheJsonOfOneProcess) {
    const auto bench = [&](const std::string& output, const std::vector<std::string>& more) {
        std::vector<std::string> all{
            "bench",        "tracers",        "--relief", "hills",     "--sizes", "16",        "--rays",
            "500",          "--rounds",       "1",        "--threads", "1",       "--tracers", "exact",
            "--elevations", "60,random,25.5", "-o",       path(output)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    runFine(bench("whole.json", {}));
    std::vector<std::string> files;
    for (const std::string part : {"3", "1", "2"}) {
        files.push_back(path(part + ".csv"));
        runFine(bench(part + ".csv", {"--part", part + "/3"}));
    }
    runFine(merge(files, "merged.json"));
    Json whole = Json::parse(read("whole.json")), merged = Json::parse(read("merged.json"));
    for (Json* table : {&whole, &merged}) {
        for (Json& row : *table) {
            EXPECT_GT(row["rate"].get<double>(), 0);
            for (const char* const name : {"rate", "spread", "build_seconds", "concurrent"}) row.erase(name);
        }
    }
    EXPECT_EQ(merged.dump(1), whole.dump(1));
}

TEST_P(MergeTest, WhatIsMissingTwiceOrOfAnotherRunIsNamed) {
    const auto parts = tables();
    const std::string even = read("even.csv");
    const auto refuse = [&](const std::vector<std::string>& files, const std::vector<std::string>& words) {
        expectRefusal(merge(files, "t.csv"), 2, words);
        EXPECT_FALSE(std::filesystem::exists(path("t.csv")));
    };
    const std::string copy = write("copy.csv", even);
    refuse({parts[0], parts[1], copy}, {parts[1], copy, "part 2 of 2"});
    const auto other = [&](const std::string& from, const std::string& to) {
        return write("other.csv", replaced(even, from, to));
    };
    refuse({parts[0], other("\"seed\":\"1\"", "\"seed\":\"2\"")},
           {parts[0], path("other.csv"), "seed is \"2\" here but \"1\" there"});
    refuse({parts[0], other("0123456789ab", "0123456789ab+")}, {"commit", "\"0123456789ab+\""});
    refuse({parts[0], other("\"rays\":64", "\"rays\":65")}, {"rays is 65 here but 64 there"});
    refuse({parts[0], other("\"of\":2", "\"of\":3")}, {"2/3", "1/2"});
    refuse({parts[0], other("tracers", "rows")}, {parts[0], path("other.csv"), "kind"});
    refuse({parts[0], other("\"relief part\":2", "\"relief part\":3")}, {path("other.csv"), "not a part"});
    expectRefusal(merge({parts[0], "--language", "uk"}, "t.csv"), 2, {"бракує: 2"});
}

TEST_P(MergeTest, WrongPartsAreRefused) {
    runFine(stress("r.jsonl", {"--part", "1/2"}));
    runFine({"render", "--relief", "bricks", "--size", "64x64", "--part", "1/2", "-o", path("p.png")});
    expectRefusal({"merge", path("r.jsonl"), path("p.png"), "-o", path("m.png")}, 2, {"p.png", "r.jsonl"});
    expectRefusal(stress("r.jsonl", {"--seconds", "0"}), 2, {"--cases", "--seconds"});
    expectRefusal({"stress", "--part", "1/2", "--record", path("r.jsonl")}, 2, {"--part", "--cases"});
    expectRefusal({"stress", "--part", "1/2", "--cases", "3"}, 2, {"--part", "--record"});
    for (const std::string text : {"0/2", "3/2", "2", "1/100001"}) {
        expectRefusal(stress("r.jsonl", {"--part", text}), 2, {"--part", "\"" + text + "\"", "2/3"});
    }
}

// The examples of README: the shell's background jobs, and GNU parallel.
TEST_P(MergeTest, SchedulersWithoutMpi) {
    const std::string begin = "cd \"$1\" && export PATH=\"$(dirname \"" RELIEF_PROGRAM "\"):$PATH\" && set -e && ";
    const auto shell = [&](const std::string& script) {
        const std::string command = "bash -c '" + begin + script + "' bash \"" + path("") + "\" >/dev/null 2>&1";
        return std::system(command.c_str());
    };
    const std::string look = "--relief city:32x32 --size 60x41 ";
    EXPECT_EQ(shell("relief render " + look + "-o whole.png"), 0);
    EXPECT_EQ(shell("for k in 1 2; do relief render " + look + "--part $k/2 -o shell$k.png & done; wait; " +
                    "relief merge shell?.png -o shell.png"),
              0);
    EXPECT_TRUE(read("shell.png") == read("whole.png"));
    if (std::system("command -v parallel >/dev/null") != 0) GTEST_SKIP() << "GNU parallel is not there";
    EXPECT_EQ(shell("parallel --will-cite relief render " + look + "--part {}/2 -o parallel{}.png ::: 1 2; " +
                    "relief merge parallel?.png -o parallel.png"),
              0);
    EXPECT_TRUE(read("parallel.png") == read("whole.png"));
}

TEST_P(MergeTest, TheExampleOfSnakemakeIsUnderstood) {
    if (std::system("command -v snakemake >/dev/null") != 0) GTEST_SKIP() << "Snakemake is not there";
    const std::string command = "cd \"" + path("") +
                                "\" && snakemake -n --cores 1 --snakefile \"" RELIEF_EXAMPLES
                                "/Snakefile\" >/dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace relief::test
