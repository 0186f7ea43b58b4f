// Parts of one run (--part K/N) and relief merge: what comes out is what one process would have written, and what does
// not belong together is refused by name.
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

// Of a table: the part line that bench writes, with this seed.
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
    static constexpr const char* kHeader = "height,method,elevation,rate\n";

    std::vector<std::string> render(const std::string& output, const std::vector<std::string>& more) const {
        std::vector<std::string> all{"render", "--relief", "bricks:48x32", "--size", "90x71", "-o", path(output)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    // The files of all parts of a picture, from the last to the first.
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
    // Records of all parts, of a small run.
    std::vector<std::string> stressed(int of) const {
        std::vector<std::string> names;
        for (int part = 1; part <= of; ++part) {
            const std::string name = "s" + std::to_string(part) + ".jsonl";
            runFine(stress(name, {"--part", std::to_string(part) + "/" + std::to_string(of)}));
            names.push_back(path(name));
        }
        return names;
    }
    // Two parts of a table of four cells; the third has no row.
    std::vector<std::string> tables() const {
        return {write("odd.csv", partLine(1, 2, "[[0,2],[2,0]]", "1") + kHeader + "\"a,b\",7,60,1.5\n\"a,b\",8,60,\n"),
                write("even.csv", partLine(2, 2, "[[1,1],[3,1]]", "1") + kHeader + "c,9,random,2\nd,10,25,3e-05\n")};
    }
};
INSTANTIATE_TEST_SUITE_P(Places, MergeTest, testing::ValuesIn(places()), placeName);

TEST_P(MergeTest, PartsOfAStressTestMakeTheReportOfOneProcess) {
    const std::string whole = runFine(stress("whole.jsonl", {}));
    std::vector<std::string> parts = stressed(3);
    std::reverse(parts.begin(), parts.end());
    EXPECT_EQ(runFine(merge(parts, "merged.jsonl")), std::regex_replace(whole, std::regex(" in [0-9.e+-]+ s;"), ";"));
    EXPECT_EQ(read("merged.jsonl"), read("whole.jsonl"));
    EXPECT_EQ(lines(read("whole.jsonl")).size(), 9U) << "the run, and eight cases";
    EXPECT_EQ(lines(read("s3.jsonl")).size(), 3U) << "cases 2 and 5";
    // Without -o the report alone.
    const auto before = files();
    runFine(merge(parts, ""));
    EXPECT_EQ(files(), before);
}

// Each part keeps the first violations of a kind; together they are more than are listed.
TEST_P(MergeTest, ViolationsAreListedAsOneProcessListsThem) {
    std::vector<std::string> parts = stressed(2);
    for (std::string& part : parts) {
        const std::string name = std::filesystem::path(part).filename().string();
        std::string text;
        for (const std::string& line : lines(read(name))) {
            Json json = Json::parse(line);
            if (json.contains("case")) {
                json["violations"] = 2;
                const std::string number = json["case"].dump();
                json["listed"] = {{{"kind", "tracers exact bits"},
                                   {"check", "bits"},
                                   {"detail", "case " + number},
                                   {"method", "exact"},
                                   {"rays", "at-limit"},
                                   {"map", "noise"},
                                   {"command", "none"}}};
            }
            text += json.dump() + "\n";
        }
        write(name, text);
    }
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
    const std::vector<std::vector<std::string>> looks{
        {"--shadows", "--scene", "cube"},
        {"--filter", "elliptical-visible", "--shadows", "--no-skip", "--camera", "elevation=20"},
        {"--supersample", "2", "--pixel-model", "gaussian"},
        {"--tracer", "displacement"}};
    for (const auto& look : looks) {
        SCOPED_TRACE(look.front() + " " + look.back());
        runFine(render("whole.png", look));
        for (const int of : {2, 5}) {
            runFine(merge(rendered(of, ".png", look), "merged.png"));
            EXPECT_TRUE(read("merged.png") == read("whole.png")) << of;
        }
    }
}

TEST_P(MergeTest, BandsOfEveryFormat) {
    runFine(render("whole.tif", {}));
    runFine(merge(rendered(3, ".tif", {}), "merged.tif"));
    EXPECT_TRUE(read("merged.tif") == read("whole.tif"));
    runFine(render("whole.exr", {}));
    runFine(merge(rendered(3, ".exr", {}), "merged.exr"));
    EXPECT_TRUE(withoutDate(read("merged.exr")) == withoutDate(read("whole.exr")));
    const std::vector<std::string> layers{"--layers", "color,depth,uv,normal,steps,outcome,error,footprint,hidden",
                                          "--filter", "elliptical-visible"};
    runFine(render("whole.exr", layers));
    for (const int of : {2, 5}) {
        runFine(merge(rendered(of, ".exr", layers), "merged.exr"));
        EXPECT_TRUE(withoutDate(read("merged.exr")) == withoutDate(read("whole.exr"))) << of;
    }
    // A single band; and one of as many as there are rows.
    runFine(merge(rendered(1, ".png", {}), "one.png"));
    runFine(render("whole.png", {}));
    EXPECT_TRUE(read("one.png") == read("whole.png"));
    runFine(render("row.png", {"--part", "71/71"}));
    EXPECT_NE(runFine({"info", path("row.png")}).find("90 x 1"), std::string::npos);
}

TEST_P(MergeTest, PartsOfManyPicturesAreEachNth) {
    const auto frames = [&](const std::string& folder, const std::vector<std::string>& more) {
        auto all = render(folder, {"--to", "elevation=60", "--frames", "4"});
        all.insert(all.end(), more.begin(), more.end());
        runFine(all);
    };
    frames("whole", {});
    frames("parts", {"--part", "2/3"});
    EXPECT_TRUE(std::filesystem::exists(path("parts/frame_00001.png")));
    EXPECT_FALSE(std::filesystem::exists(path("parts/frame_00000.png")));
    frames("parts", {"--part", "1/3"});
    frames("parts", {"--part", "3/3"});
    for (int f = 0; f < 4; ++f) {
        const std::string name = "/frame_0000" + std::to_string(f) + ".png";
        EXPECT_TRUE(read("parts" + name) == read("whole" + name)) << f;
    }
}

TEST_P(MergeTest, TablesGetTheirRowsInTheOrderOfTheCells) {
    auto parts = tables();
    std::reverse(parts.begin(), parts.end());
    runFine(merge(parts, "t.csv"));
    EXPECT_EQ(read("t.csv"), std::string(kHeader) + "\"a,b\",7,60,1.5\n\"a,b\",8,60,\nc,9,random,2\nd,10,25,3e-05\n");
    runFine(merge(parts, "t.json"));
    const Json rows = Json::parse(read("t.json"));
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[0].dump(), R"({"height":"a,b","method":"7","elevation":60,"rate":1.5})");
    EXPECT_EQ(rows[1]["rate"], nullptr);
    EXPECT_EQ(rows[2]["elevation"], "random");
    EXPECT_EQ(rows[3]["rate"], 3e-05);
}

TEST_P(MergeTest, WrongTablesAreRefused) {
    const auto parts = tables();
    const std::string odd = read("odd.csv");
    const auto refuse = [&](const std::string& text, const std::vector<std::string>& words) {
        auto all = words;
        all.push_back(write("bad.csv", text) + ": ");
        const auto before = files();
        expectRefusal(merge({path("bad.csv"), parts[1]}, "t.csv"), 2, all);
        EXPECT_EQ(files(), before);
    };
    refuse(odd.substr(0, odd.size() - 1), {"line 4"});
    refuse(odd.substr(0, odd.size() - 3), {"line 4"});
    refuse(odd.substr(0, odd.find("\n\"a,b\",8") + 1), {"tells of 2 rows, 1 are here"});
    refuse(odd + "e,1,2,3\n", {"2 rows, 3"});
    refuse(replaced(odd, "[[0,2],[2,0]]", "[[0,2],[1,0]]"), {"line 1"});
    refuse(replaced(odd, "[[0,2],[2,0]]", "[[2,2]]"), {"line 1"});
    refuse(replaced(odd, "height,method", "height,form"), {});
    expectRefusal(merge(parts, "t.png"), 2, {path("t.png"), ".csv, .json"});
    expectRefusal(merge(parts, ""), 2, {"--output"});
    expectRefusal(merge(parts, "no/t.csv"), 1, {path("no/t.csv")});
}

TEST_P(MergeTest, WhatIsMissingTwiceOrOfAnotherRunIsNamed) {
    const auto parts = tables();
    const std::string even = read("even.csv");
    const auto refuse = [&](const std::vector<std::string>& files, const std::vector<std::string>& words) {
        expectRefusal(merge(files, "t.csv"), 2, words);
        EXPECT_FALSE(std::filesystem::exists(path("t.csv")));
    };
    refuse({parts[0]}, {parts[0], "missing: 2"});
    refuse({parts[0], parts[1], parts[0]}, {parts[0], "part 1 of 2"});
    const std::string copy = write("copy.csv", even);
    refuse({parts[0], parts[1], copy}, {parts[1], copy, "part 2 of 2"});
    const auto other = [&](const std::string& from, const std::string& to) {
        return write("other.csv", replaced(even, from, to));
    };
    refuse({parts[0], other("\"seed\":\"1\"", "\"seed\":\"2\"")},
           {parts[0], path("other.csv"), "seed is \"2\" here, \"1\" there"});
    refuse({parts[0], other("0123456789ab", "0123456789ab+")}, {"commit", "\"0123456789ab+\""});
    refuse({parts[0], other("\"rays\":64", "\"rays\":65")}, {"rays is 65 here, 64 there"});
    refuse({parts[0], other("00112233aabbccdd", "ffffffffffffffff")}, {"cells"});
    refuse({parts[0], other("\"of\":2", "\"of\":3")}, {"2/3", "1/2"});
    refuse({parts[0], other("tracers", "rows")}, {parts[0], path("other.csv"), "kind"});
    refuse({parts[0], other("\"relief part\":2", "\"relief part\":3")}, {path("other.csv"), "no part"});
    refuse({parts[0], write("plain.csv", kHeader)}, {path("plain.csv")});
    refuse({parts[0], write("hash.csv", "# a comment\n")}, {path("hash.csv"), "no part"});
    refuse({parts[0], path("none.csv")}, {path("none.csv"), "no such file"});
    runFine(render("p.png", {"--part", "1/2"}));
    refuse({parts[0], path("p.png")}, {parts[0], path("p.png"), "kind"});
    expectRefusal({"merge", "-o", path("t.csv")}, 2, {"FILE"});
    expectRefusal(merge({parts[0], "--language", "uk"}, "t.csv"), 2, {"бракує: 2"});
}

TEST_P(MergeTest, WrongRecordsAreRefused) {
    const auto parts = stressed(2);
    const std::string second = read("s2.jsonl");
    const auto refuse = [&](const std::string& text, const std::vector<std::string>& words) {
        auto all = words;
        all.push_back(write("bad.jsonl", text) + ": ");
        expectRefusal(merge({parts[0], path("bad.jsonl")}, "m.jsonl"), 2, all);
        EXPECT_FALSE(std::filesystem::exists(path("m.jsonl")));
    };
    refuse(second.substr(0, second.size() - 1), {"line 5"});
    refuse(second.substr(0, second.size() - 20), {"line 5"});
    refuse(second.substr(0, second.find("\n{\"case\":7") + 1), {"line 5"});
    refuse(second + lines(second).back() + "\n", {"line 6"});
    refuse(replaced(second, "\"case\":3", "\"case\":5"), {"line 3"});
    refuse(replaced(second, "\"seed\":7", "\"seed\":8"), {"seed is 8 here, 7 there"});
    refuse(replaced(second, "\"commit\":\"", "\"commit\":\"f"), {"commit"});
    refuse(replaced(second, "exact,layers:layers=3", "exact"), {"tracers is \"exact\""});
    runFine(stress("whole.jsonl", {}));
    expectRefusal(merge({path("whole.jsonl")}, ""), 2, {path("whole.jsonl"), "no part"});
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all{"stress", "--seconds", "0"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    expectRefusal(with({"--cases", "3"}), 2, {"--cases", "--seconds"});
    expectRefusal(with({"--part", "1/2", "--record", path("r.jsonl")}), 2, {"--part", "--cases"});
    expectRefusal({"stress", "--part", "1/2", "--cases", "3"}, 2, {"--part", "--record"});
    expectRefusal({"stress", "--cases", "0"}, 2, {"--cases"});
    expectRefusal({"stress", "--cases", "3", "--record", path("r.txt")}, 2, {".jsonl"});
    for (const std::string text : {"0/2", "3/2", "2", "1/0", "1/2/3", "-1/2", "1/100001", "a/b", ""}) {
        expectRefusal(stress("r.jsonl", {"--part", text}), 2, {"--part", "\"" + text + "\"", "2/3"});
    }
}

TEST_P(MergeTest, WrongBandsAreRefused) {
    const std::vector<std::string> look{"--scene", "wall"};
    const auto parts = rendered(2, ".png", look);
    const auto refuse = [&](const std::vector<std::string>& files, const std::vector<std::string>& words) {
        expectRefusal(merge(files, "m.png"), 2, words);
        EXPECT_FALSE(std::filesystem::exists(path("m.png")));
    };
    refuse({parts[0]}, {parts[0], "missing: 1"});
    refuse({parts[0], parts[0]}, {parts[0], "part 2 of 2"});
    runFine(render("other.png", {"--scene", "floor", "--part", "1/2"}));
    refuse({parts[0], path("other.png")}, {path("other.png"), "scene is \"floor\" here, \"wall\" there"});
    runFine({"render", "--relief", "bricks:48x32:9", "--size", "90x71", "--scene", "wall", "--part", "1/2", "-o",
             path("other.png")});
    refuse({parts[0], path("other.png")}, {path("other.png"), "seed is 9 here"});
    runFine(render("plain.png", look));
    refuse({parts[0], path("plain.png")}, {path("plain.png"), "no part"});
    const std::string bytes = read("p1of2.png");
    refuse({parts[0], write("cut.png", bytes.substr(0, bytes.size() - 30))}, {path("cut.png")});
    const auto floats = rendered(2, ".exr", look);
    const std::string exr = read("p1of2.exr");
    refuse({parts[0], path("p1of2.exr")}, {});
    expectRefusal(merge({floats[0], write("cut.exr", exr.substr(0, exr.size() / 2))}, "m.exr"), 2, {path("cut.exr")});
    expectRefusal(merge(floats, "m.png"), 2, {path("m.png"), ".exr"});
    expectRefusal(merge(parts, "no/m.png"), 1, {path("no/m.png")});
    for (const std::string name : {"p.jpg", "p.hdr", "p.bmp"}) {
        expectRefusal(render(name, {"--part", "1/2"}), 2, {path(name), ".png"});
    }
    expectRefusal(render("p.png", {"--part", "1/2", "--report", "-"}), 2, {"--report", "--part"});
    expectRefusal(render("p.png", {"--part", "1/72"}), 2, {"--part", "72", "71"});
}

// README's examples: the shell's own jobs, and GNU parallel.
TEST_P(MergeTest, SchedulersWithoutMpi) {
    const std::string begin = "cd \"$1\" && relief() { " RELIEF_PROGRAM " \"$@\"; } && export -f relief && set -e && ";
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
