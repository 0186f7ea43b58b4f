#include "measuring/lesson/lesson_text.h"

#include <map>
#include <optional>
#include <sstream>

#include "relief/describe.h"
#include "scenario/text_lines.h"

namespace relief {

namespace {

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

// Collects the lines of the file under their headings.
class TextReader {
  public:
    explicit TextReader(const std::string& fileName) : fileName_(fileName) {}

    void line(const std::string& line, std::size_t number) {
        number_ = number;
        if (line.starts_with("### ")) return section(trimmed(line.substr(4)));
        if (line.starts_with("## ")) return page(line.substr(3));
        if (line.starts_with("# ")) {
            if (!out_.title.empty()) fail(Message(MessageId::LessonTitleTwice));
            out_.title = trimmed(line.substr(2));
            target_ = &out_.about;
            return;
        }
        if (out_.title.empty() && !trimmed(line).empty()) fail(Message(MessageId::LessonNoTitle));
        if (asking_ && line.starts_with("- ")) {
            out_.pages.back().choices.push_back(trimmed(line.substr(2)));
            return;
        }
        if (target_ == nullptr) return;
        // The answers of a question may go over several lines.
        if (asking_ && !out_.pages.back().choices.empty() && !trimmed(line).empty()) {
            out_.pages.back().choices.back() += " " + trimmed(line);
            return;
        }
        *target_ += line + "\n";
    }
    LessonText finished() {
        if (out_.title.empty()) fail(Message(MessageId::LessonNoTitle));
        for (std::string* words : {&out_.about, &out_.remember, &out_.note, &out_.source}) *words = trimmed(*words);
        for (PageText& page : out_.pages) {
            for (std::string* words : {&page.text, &page.question, &page.hint, &page.answer, &page.knob, &page.note}) {
                *words = trimmed(*words);
            }
        }
        return std::move(out_);
    }

  private:
    [[noreturn]] void fail(const Message& why) const {
        throw InputError(fileName_, Message(MessageId::ScenarioLine, {{"line", number_}, {"why", why}}));
    }
    void page(const std::string& heading) {
        const std::size_t colon = heading.find(':');
        PageText page;
        page.name = trimmed(heading.substr(0, colon));
        if (colon == std::string::npos || page.name.empty()) fail(Message(MessageId::LessonPageHeading));
        page.title = trimmed(heading.substr(colon + 1));
        out_.pages.push_back(std::move(page));
        asking_ = false;
        target_ = &out_.pages.back().text;
    }
    void section(const std::string& name) {
        std::map<std::string, std::string*> known;
        if (out_.pages.empty()) {
            known = {{"remember", &out_.remember}, {"note", &out_.note}, {"source", &out_.source}};
        } else {
            PageText& page = out_.pages.back();
            known = {{"question", &page.question},
                     {"hint", &page.hint},
                     {"answer", &page.answer},
                     {"knob", &page.knob},
                     {"note", &page.note}};
        }
        const auto found = known.find(name);
        if (found == known.end()) {
            std::vector<std::string> names;
            for (const auto& entry : known) names.push_back(entry.first);
            fail(unknownName({"what", MessageId::WordSection}, name, commaList(names)));
        }
        target_ = found->second;
        asking_ = name == "question";
    }

    const std::string& fileName_;
    std::size_t number_ = 1;
    LessonText out_;
    std::string* target_ = nullptr;
    bool asking_ = false;
};

// A piece of words between marks. kind: '{' a value, '$' a formula, '`' code, '*' emphasis, 0 plain text.
struct Piece {
    char kind = 0;
    std::string text;
};

std::vector<Piece> piecesOf(const std::string& words) {
    std::vector<Piece> pieces;
    std::string plain;
    const auto flush = [&] {
        if (!plain.empty()) pieces.push_back({0, std::exchange(plain, {})});
    };
    for (std::size_t at = 0; at < words.size(); ++at) {
        const char mark = words[at];
        if (mark != '{' && mark != '$' && mark != '`' && mark != '*') {
            plain += mark;
            continue;
        }
        const std::size_t end = words.find(mark == '{' ? '}' : mark, at + 1);
        if (end == std::string::npos) {
            if (mark == '{')
                throw InputError("", Message(MessageId::LessonOpenBrace, {{"text", quoted(words.substr(at))}}));
            plain += mark;
            continue;
        }
        flush();
        pieces.push_back({mark, words.substr(at + 1, end - at - 1)});
        at = end;
    }
    flush();
    return pieces;
}

ValueSlot slotOf(const std::string& text) {
    bool inQuotes = false;
    std::size_t colon = std::string::npos;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '\'') inQuotes = !inQuotes;
        if (text[at] == ':' && !inQuotes) colon = at;
    }
    return {trimmed(text.substr(0, colon)),
            colon == std::string::npos ? std::string() : trimmed(text.substr(colon + 1))};
}

// Subscripts and superscripts: _ and ^ before a letter or a group in braces.
std::string formulaHtml(const std::string& formula) {
    std::string out;
    for (std::size_t at = 0; at < formula.size(); ++at) {
        const char mark = formula[at];
        if ((mark != '_' && mark != '^') || at + 1 == formula.size()) {
            const std::size_t end = std::min(formula.find_first_of("_^", at + 1), formula.size());
            out += escapedHtml(formula.substr(at, end - at));
            at = end - 1;
            continue;
        }
        std::string group;
        if (formula[at + 1] == '{') {
            const std::size_t end = std::min(formula.find('}', at), formula.size());
            group = formula.substr(at + 2, end - at - 2);
            at = end;
        } else {
            // The whole character, which may have several bytes.
            do group += formula[++at];
            while (at + 1 < formula.size() && (static_cast<unsigned char>(formula[at + 1]) & 0xC0U) == 0x80U);
        }
        const std::string tag = mark == '_' ? "sub" : "sup";
        out += "<" + tag + ">" + escapedHtml(group) + "</" + tag + ">";
    }
    return "<i>" + out + "</i>";
}

}  // namespace

LessonText parseLessonText(const std::string& text, const std::string& fileName) {
    TextReader reader(fileName);
    std::string_view rest = withoutMark(text);
    for (std::size_t number = 1; !rest.empty(); ++number) reader.line(std::string(takeLine(rest)), number);
    return reader.finished();
}

std::string lessonTextFile(const LessonText& text) {
    std::string out = "# " + text.title + "\n\n" + text.about + "\n";
    const auto add = [&](const char* name, const std::string& words) {
        if (!words.empty()) out += std::string("\n### ") + name + "\n" + words + "\n";
    };
    add("remember", text.remember);
    add("note", text.note);
    add("source", text.source);
    for (const PageText& page : text.pages) {
        out += "\n## " + page.name + ": " + page.title + "\n\n" + page.text + "\n";
        std::string question = page.question;
        for (const std::string& choice : page.choices) question += "\n- " + choice;
        add("question", question);
        add("hint", page.hint);
        add("answer", page.answer);
        add("knob", page.knob);
        add("note", page.note);
    }
    return out;
}

std::vector<ValueSlot> valueSlots(const std::string& words) {
    std::vector<ValueSlot> slots;
    for (const Piece& piece : piecesOf(words)) {
        if (piece.kind == '{') slots.push_back(slotOf(piece.text));
    }
    return slots;
}

std::string lessonLine(const std::string& words, const std::function<std::string(const ValueSlot&)>& value) {
    std::string out;
    for (const Piece& piece : piecesOf(words)) {
        switch (piece.kind) {
            case '{':
                out += "<b>" + escapedHtml(value(slotOf(piece.text))) + "</b>";
                break;
            case '$':
                out += formulaHtml(piece.text);
                break;
            case '`':
                out += "<code>" + escapedHtml(piece.text) + "</code>";
                break;
            case '*':
                out += "<i>" + escapedHtml(piece.text) + "</i>";
                break;
            default:
                out += escapedHtml(piece.text);
        }
    }
    return out;
}

std::string lessonHtml(const std::string& words, const std::function<std::string(const ValueSlot&)>& value) {
    std::string out, paragraph;
    const auto close = [&] {
        if (!trimmed(paragraph).empty()) out += "<p>" + lessonLine(trimmed(paragraph), value) + "</p>\n";
        paragraph.clear();
    };
    std::istringstream lines(words);
    for (std::string line; std::getline(lines, line);) {
        if (trimmed(line).empty()) {
            close();
        } else {
            paragraph += line + "\n";
        }
    }
    close();
    return out;
}

int wordCount(const std::string& words) {
    std::string plain;
    for (const Piece& piece : piecesOf(words)) plain += piece.kind == 0 || piece.kind == '*' ? piece.text : "x";
    int count = 0;
    std::istringstream text(plain);
    for (std::string word; text >> word;) {
        // Punctuation between spaces, such as a dash, is no word.
        const bool letters = std::any_of(word.begin(), word.end(), [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) != 0 || (static_cast<unsigned char>(c) & 0x80U) != 0;
        });
        if (letters && word != "–" && word != "—") ++count;
    }
    return count;
}

std::string escapedHtml(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

}  // namespace relief
