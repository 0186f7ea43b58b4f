// Compares two to four methods, filters, mappings or height maps with the same camera: side by side, in one picture
// with dividers, alternating, or as differences; below each picture its error against a reference and its speed.
// Everything is rendered and measured on a thread of the pane's own.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "panes/compare/compare_data.h"
#include "panes/figure_view.h"
#include "panes/picture_view.h"
#include "workspace/latest_job.h"

class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace reliefui {

class OptionsForm;
class RangeButton;

// The pictures, with the same mouse and keys as the result view, and draggable dividers.
class ComparePictures : public PictureView {
    Q_OBJECT
  public:
    explicit ComparePictures(Workspace* workspace, QWidget* parent = nullptr);

    // Shows a view; null: shows the message `why` instead.
    void show(std::shared_ptr<const ComparedView> view, relief::MessageId why);
    const ComparedView* view() const { return view_.get(); }
    const CompareLayout& layoutNow() const { return layout_; }
    // Index of the visible picture in flicker mode.
    std::size_t shown() const { return shown_; }
    void setShown(std::size_t number);
    // Progress of the pending pictures, 0 to 1; 0: just started.
    void setProgress(double fraction);
    void setStopped();
    // Returns true if a visible picture does not belong to the current scenario.
    bool outdated() const;
    bool veiled() const { return pending_.veil; }
    // Position of a pixel's centre in one of the pictures, if it is visible there.
    std::optional<QPointF> pixelIn(std::size_t number, relief::PixelChoice pixel) const;
    // Index of the picture at this point.
    std::optional<std::size_t> pictureAt(QPointF widget) const;
    void relayout();
    // The scale of differences on the screen; std::nullopt if there is none.
    std::optional<RangedValues> errors() const;

  signals:
    void rangeRequested();  // the colour bar was clicked
    void hovered(const QString& readout);
    void flickerStopped();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;
    QRectF roomAt(QPointF widget) const override;
    void readOutHover(QPointF at) override;

  private:
    // The scenario, with the divider's current position during a drag.
    relief::Scenario currentScenario() const;
    void setPendingText(relief::Message text);
    double unit() const { return workspace()->style().pixelsPerPoint(); }
    QRectF onScreen(const Box& points) const;
    std::optional<std::size_t> dividerAt(QPointF widget) const;
    bool moveDivider(QKeyEvent* event);
    QRectF legendBar() const;  // colour bar in widget coordinates; empty: there is none
    bool dragsFit() const { return layout_.dividers.size() == dividers_.size(); }
    QStringList readouts(relief::PixelChoice pixel) const;

    std::shared_ptr<const ComparedView> view_;
    relief::MessageId why_ = relief::MessageId::DrawNoPicture;
    CompareLayout layout_;
    Drawing legend_;
    std::optional<RangedValues> errors_;
    Box room_;               // box of the layout on this widget
    std::size_t lines_ = 0;  // text lines of the last layout in this mode
    relief::CompareMode mode_{};
    std::size_t shown_ = 0;
    std::optional<std::size_t> dragged_;  // index of the divider being dragged
    std::size_t held_ = 0;                // divider selected with the keyboard
    std::vector<double> dividers_;        // positions during a drag
    ComparePending pending_;
    QTimer veil_;
};

class CompareView : public FigureView {
    Q_OBJECT
  public:
    explicit CompareView(Workspace* workspace, QWidget* parent = nullptr);
    ~CompareView() override;

    ComparePictures* pictures() const { return pictures_; }
    const ComparedView* view() const { return view_.get(); }
    // Returns true if no computation is pending.
    bool isUpToDate() const;

  public slots:
    void setSubject(relief::CompareSubject subject);
    // Adds the next choice that is not compared yet.
    void addOther();
    void removeOther();
    // Sets the choice at a place (0 is A). A choice that is already at another place changes places with it; one equal
    // to A gets a differing option, or is refused with a message.
    void setChoice(std::size_t number, const QString& name);
    // Sets an option of a choice, by the key in its description ("inner.layers").
    void setOption(std::size_t number, const QString& name, const QString& text, bool live = false);
    // Shows or hides the options of all choices.
    void showOptions(bool on);
    // Makes it A, the method that all panes show; the previous A takes its place.
    void swapWithA(std::size_t number);
    void setMode(relief::CompareMode mode);
    void setMeasure(relief::CompareMeasure measure);
    void setReference(relief::CompareReference reference);
    bool cancel() override;

  protected:
    void showSnapshot() override;
    bool outdated() const override;
    std::shared_ptr<const Figure> figure() const override;
    void readOut(const QPointF& widget) override;
    void addToMenu(QMenu& menu) override;
    void releaseContents() override;

  private:
    QWidget* makeMethodBar();
    void makeModeBar();
    QWidget* makeOptions();
    void refreshOptions();
    void showControls();
    void change(const relief::Comparison& comparison, const QString& what);
    void startView();
    // Continues with the next stage for the pictures shown: recolouring by the current ranges, then rates.
    void proceed();
    // Starts a job that derives a new view from the current one.
    void make(std::function<std::shared_ptr<const ComparedView>(relief::Work&)> work);
    void fillChoosers();
    void tick();

    QHBoxLayout* bar_ = nullptr;  // the row currently being filled
    ComparePictures* pictures_;
    std::vector<QComboBox*> choosers_;
    std::optional<relief::CompareSubject> offered_;  // subject of the choosers' entries
    // One choice's name above its options.
    struct OptionsOf {
        QWidget* whole = nullptr;
        QLabel* title = nullptr;
        OptionsForm* form = nullptr;
    };
    std::vector<OptionsOf> options_;
    QWidget* optionsArea_ = nullptr;
    QToolButton* showOptions_ = nullptr;
    QToolButton* add_ = nullptr;
    QToolButton* remove_ = nullptr;
    QComboBox* subject_ = nullptr;
    QComboBox* mode_ = nullptr;
    QComboBox* measure_ = nullptr;
    QComboBox* reference_ = nullptr;
    QDoubleSpinBox* rate_ = nullptr;
    QToolButton* play_ = nullptr;
    RangeButton* range_ = nullptr;
    QPoint menuAt_;

    std::shared_ptr<const Snapshot> snapshot_;
    std::shared_ptr<const ComparedView> view_;
    std::shared_ptr<Comparer> comparer_ = std::make_shared<Comparer>();  // used by the job
    bool coarseRunning_ = false;
    QTimer flicker_;
    std::uint64_t run_ = 0;  // number of the job whose pictures are shown one by one; others are ignored
    Mailbox parts_{this};
    std::unique_ptr<LatestJob> job_;  // last member: its thread ends before the others are destroyed
};

}  // namespace reliefui
