#include "windows/moving_picture.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include <QImageReader>

#include "measuring/lesson/lesson_text.h"
#include "relief/files.h"
#include "windows/lesson_html.h"

namespace reliefui {

namespace fs = std::filesystem;

namespace {

using relief::Sequence;

constexpr const char* kOption = "--sequence";
constexpr int kAngleDigits = 6;

// A figure whose caption begins with what changes from frame to frame.
class FrameFigure : public Figure {
  public:
    FrameFigure(std::shared_ptr<const Figure> figure, std::string changed)
        : figure_(std::move(figure)), changed_(std::move(changed)) {}
    std::shared_ptr<const Figure> prepared(const FigurePage& page, relief::Work& work) const override {
        auto ready = figure_->prepared(page, work);
        return ready ? std::make_shared<FrameFigure>(std::move(ready), changed_) : nullptr;
    }
    bool vectors() const override { return figure_->vectors(); }
    double aspect(const FigurePage& page) const override { return figure_->aspect(page); }
    void paint(QPainter& painter, const Box& page, const Style& style) const override {
        figure_->paint(painter, page, style);
    }
    std::string caption(relief::Language language) const override {
        const std::string own = figure_->caption(language);
        return own.empty() ? changed_ : changed_ + " · " + own;
    }
    QImage image(const FigurePage& page, const QSize& size) const override { return figure_->image(page, size); }

  private:
    std::shared_ptr<const Figure> figure_;
    std::string changed_;
};

// The snapshots of the frames, one after the other.
class Frames {
  public:
    Frames(const MovingPicture& moving, SnapshotMaker& maker, relief::Work& work)
        : moving_(moving), maker_(maker), work_(work) {
        if (turns()) {
            turns_ = moving.sequence.frames.value_or(relief::kSequenceFrames);
            stepped_ = maker.make(moving.order, work);
            return;
        }
        if (moving.sequence.kind != Sequence::Kind::Steps) {
            frames_ = relief::framesOf(moving.sequence, moving.order.scenario, kOption);
            return;
        }
        if (!followsSteps(moving.kind)) throw relief::stepsNotShown(moving.kind.name, kOption);
        stepped_ = maker.make(moving.order, work);
        moving.kind.make(stepped_, stepped_->scenario);  // throws if there is no ray
    }
    std::size_t size() const {
        if (turns_ > 0) return static_cast<std::size_t>(turns_);
        return stepped_ ? std::max<std::size_t>(stepped_->trace.steps.size(), 1) : frames_.size();
    }
    // Computes what the frame shows. Returns the function that makes its figure.
    FrameMaker maker(std::size_t number) {
        const FigureKind& kind = moving_.kind;
        if (turns_ > 0)
            return [&kind, s = stepped_, angle = turn(number)] { return kind.turned(s, s->scenario, angle); };
        std::shared_ptr<const Snapshot> snapshot;
        if (stepped_) {
            auto other = std::make_shared<Snapshot>(*stepped_);
            other->scenario.step = static_cast<int>(number);
            snapshot = std::move(other);
        } else {
            SnapshotOrder order = moving_.order;
            order.scenario = frames_[number].scenario;
            snapshot = maker_.make(order, work_);
        }
        return [&kind, snapshot] { return kind.make(snapshot, snapshot->scenario); };
    }
    std::string changed(std::size_t number) const {
        if (turns_ > 0) return "turn = " + value(number);
        // Of steps, the caption says the number anyway.
        return stepped_ ? std::string() : frames_[number].changed();
    }
    std::string value(std::size_t number) const {
        if (turns_ > 0) return relief::numberText(turn(number), kAngleDigits) + "°";
        return stepped_ ? std::to_string(number + 1) : frames_[number].value;
    }
    // Of a sequence of steps, the chosen one; otherwise null.
    std::shared_ptr<const Snapshot> chosen() const { return turns_ > 0 ? nullptr : stepped_; }

  private:
    // An orbit around a 3-D view leads around what it shows, not around the scene.
    bool turns() const { return moving_.sequence.kind == Sequence::Kind::Orbit && moving_.kind.turned; }
    double turn(std::size_t number) const { return 360.0 * static_cast<double>(number) / turns_; }

    const MovingPicture& moving_;
    SnapshotMaker& maker_;
    relief::Work& work_;
    int turns_ = 0;                            // number of frames around a 3-D view; 0: another sequence
    std::shared_ptr<const Snapshot> stepped_;  // of these, and of a sequence of steps
    std::vector<relief::SequenceFrame> frames_;
};

// Frames of a longer sequence would be taken for the end of this one.
void refuseLonger(const fs::path& folder, const std::string& stem, const std::string& ending, std::size_t frames) {
    std::error_code fault;
    for (const auto& entry : fs::directory_iterator(folder, fault)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(stem + "_") || !name.ends_with(ending)) continue;
        const char* const begin = name.data() + stem.size() + 1;
        const char* const end = name.data() + name.size() - ending.size();
        std::size_t number = 0;
        const auto read = std::from_chars(begin, std::max(begin, end), number);
        if (begin >= end || read.ec != std::errc() || read.ptr != end || number < frames) continue;
        throw relief::longerSequence(entry.path().string());
    }
}

// Makes all pictures as high as the highest: captions may take one line more in some frames.
void makeEqual(const std::vector<std::string>& files, const Style& style) {
    std::vector<QSize> sizes;
    int highest = 0;
    for (const std::string& file : files) {
        sizes.push_back(QImageReader(QString::fromStdString(file)).size());
        highest = std::max(highest, sizes.back().height());
    }
    for (std::size_t n = 0; n < files.size(); ++n) {
        if (sizes[n].height() == highest) continue;
        const QImage picture(QString::fromStdString(files[n]));
        QImage whole(picture.width(), highest, QImage::Format_RGB32);
        whole.setDotsPerMeterX(picture.dotsPerMeterX());
        whole.setDotsPerMeterY(picture.dotsPerMeterY());
        whole.fill(toColor(style.background()));
        QPainter(&whole).drawImage(0, 0, picture);
        relief::AtomicFile target(files[n]);
        if (!whole.save(QString::fromStdString(target.temporaryPath()), "PNG"))
            throw relief::WorkError(files[n], relief::Message(relief::MessageId::DiskFull));
        target.commit();
    }
}

}  // namespace

void writeFrames(const MovingPicture& moving, SnapshotMaker& maker, const FigurePage& page, const std::string& path,
                 const FrameProgress& progress, relief::Work& work) {
    checkPage(page, path, moving.kind.vectors);
    const fs::path folder = fs::path(path).parent_path();
    const std::string stem = fs::path(path).stem().string(), ending = fs::path(path).extension().string();
    Frames frames(moving, maker, work);
    refuseLonger(folder.empty() ? "." : folder, stem, ending, frames.size());
    std::error_code fault;
    if (!folder.empty()) fs::create_directories(folder, fault);
    if (fault) {
        throw relief::WorkError(folder.string(),
                                relief::Message(relief::MessageId::FileUnwritable, {{"why", fault.message()}}));
    }
    std::vector<std::string> files;
    for (std::size_t n = 0; n < frames.size(); ++n) {
        work.throwIfStopped();
        std::shared_ptr<const Figure> figure = frames.maker(n)();
        if (const std::string changed = frames.changed(n); !changed.empty())
            figure = std::make_shared<FrameFigure>(std::move(figure), changed);
        files.push_back((folder / (relief::frameName(stem, n) + ending)).string());
        writeFigure(*figure, page, files.back(), work);
        progress(n + 1, frames.size());
    }
    if (ending == ".png") makeEqual(files, page.style);
}

std::string movingPage(const MovingPicture& moving, SnapshotMaker& maker, const LanguageSetter& installLanguage,
                       const FrameProgress& progress, relief::Work& work) {
    Frames frames(moving, maker, work);
    if (frames.chosen() && hasStepDrawings(moving.kind))
        return viewPage(moving.kind, frames.chosen(), installLanguage, work);
    HtmlParts parts;
    // The pictures of a long ray's steps would make the page too large.
    const std::size_t all = frames.size(), shown = frames.chosen() ? std::min(all, kMostPageSteps) : all;
    const FrameSource source = [&](const FrameVisitor& visit) {
        for (std::size_t n = 0; n < shown; ++n) {
            work.throwIfStopped();
            const std::size_t frame = shown == all ? n : n * (all - 1) / (shown - 1);
            visit(frames.maker(frame), frames.value(frame), frames.changed(frame));
            progress(n + 1, shown);
        }
    };
    const std::string figure = framesFigure(moving.kind, source, parts, installLanguage, work);
    return wholePage(moving.kind.name, moving.kind.name,
                     "<h1>" + relief::escapedHtml(moving.kind.name) + "</h1>\n" + figure, parts);
}

}  // namespace reliefui
