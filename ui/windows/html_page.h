// Pages for any browser: one HTML file with everything in it, which needs no program and no network. Drawings are
// inline SVG whose steps share their parts, pictures are data URIs. Without scripts the pages show the chosen step.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <QImage>

#include "panes/pane.h"

namespace reliefui {

inline constexpr std::array<relief::Language, 2> kPageLanguages{relief::Language::English, relief::Language::Ukrainian};
// Suffix of keys and of CSS classes: "en", "uk".
const char* languageCode(relief::Language language);

// Throws InputError unless the file's name ends in ".html".
void checkHtmlFile(const std::string& path);

// A word of the page in both languages.
std::string inBoth(const std::string& english, const std::string& ukrainian);

// The parts of all drawings of a page. Equal parts - most of what two steps show - are stored once.
class HtmlParts {
  public:
    // Takes a drawing apart. Returns the numbers of its parts.
    std::vector<int> add(const std::string& svg);
    // Adds a picture as an element of a drawing that has its size in pixels. Returns the number of the part.
    int add(const QImage& picture);
    // Marks parts that sliders put into their drawings. The others are only where the page shows them at first.
    void setNeeded(const std::vector<int>& numbers);
    const std::string& part(int number) const { return parts_[static_cast<std::size_t>(number)]; }
    // The script element that holds the marked parts, and 0 for the others, for the end of the page.
    std::string script() const;
    std::size_t bytes() const { return bytes_; }

  private:
    int addPart(std::string part);

    std::vector<std::string> parts_;
    std::map<std::string, int> numbers_;
    std::set<int> needed_;
    std::size_t bytes_ = 0;
};

using LanguageSetter = std::function<void(relief::Language)>;
// Installs the translation of a language; there must be no window.
void installPageLanguage(relief::Language language);

inline constexpr std::size_t kMostPageSteps = 40;  // of a slider
// Draws the pane's figure at the steps of the snapshot's ray and returns it as a <figure> with a slider, or without one
// if it is the same at all steps. About kMostFigureBytes of new parts at most: of longer rays, steps are left out.
// installLanguage: sets the language of the figures' texts.
std::string stepsFigure(const FigureKind& kind, const std::shared_ptr<const Snapshot>& snapshot, HtmlParts& parts,
                        const LanguageSetter& installLanguage, relief::Work& work);
inline constexpr std::size_t kMostFigureBytes = 700000;

// Returns false if stepsFigure() makes one picture, without a slider.
bool hasStepDrawings(const FigureKind& kind);
// Returns false if the figure is the same at all steps.
bool followsSteps(const FigureKind& kind);

// The frames of a moving picture: calls the function with each frame's figure (which is made in each language), the
// text of the slider for it, and what the text below begins with (may be empty).
using FrameMaker = std::function<std::shared_ptr<const Figure>()>;
using FrameVisitor = std::function<void(const FrameMaker& make, const std::string& value, const std::string& changed)>;
using FrameSource = std::function<void(const FrameVisitor&)>;
// Draws the pane's figure of all frames and returns it as a <figure> with a slider. Drawings that would be large as
// vectors become pictures.
std::string framesFigure(const FigureKind& kind, const FrameSource& frames, HtmlParts& parts,
                         const LanguageSetter& installLanguage, relief::Work& work);

// An <img> with the picture in it; alt in the language of its surroundings.
std::string pictureHtml(const QImage& picture, const std::string& alt);

// The whole file: title in both languages, the body's content, the parts, and the script that moves the sliders.
std::string wholePage(const std::string& english, const std::string& ukrainian, const std::string& body,
                      const HtmlParts& parts);

}  // namespace reliefui
