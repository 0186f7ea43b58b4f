#include "lessons/lesson_pane.h"

#include <filesystem>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QScrollBar>
#include <QSlider>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "relief/describe.h"

namespace reliefui {

namespace {

constexpr double kLectureType = 1.35;

QString plain(const std::string& text) {
    return QString::fromStdString(relief::escapedHtml(text));
}

// A line of words without its paragraph.
QString inLine(const LessonPlayer& player, const std::string& words) {
    QString html = player.html(words).trimmed();
    if (html.startsWith(QLatin1String("<p>")) && html.endsWith(QLatin1String("</p>")))
        html = html.mid(3, html.size() - 7);
    return html;
}

QString link(const QString& to, const QString& html) {
    return QStringLiteral("<a href=\"%1\">%2</a>").arg(to, html);
}

QString small(const QString& html) {
    return QStringLiteral("<p><small>%1</small></p>").arg(html);
}

QToolButton* button(QWidget* parent, const QString& text, const QString& help, const char* name) {
    auto* const made = new QToolButton(parent);
    made->setText(text);
    made->setToolTip(help);
    made->setAccessibleName(help);
    made->setObjectName(QLatin1String(name));
    made->setAutoRaise(true);
    return made;
}

}  // namespace

LessonPane::LessonPane(Workspace* workspace, LessonPlayer* player, QWidget* parent)
    : QWidget(parent), workspace_(workspace), player_(player) {
    setObjectName(QStringLiteral("lesson"));
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(4);
    heading_ = new QLabel(this);
    heading_->setWordWrap(true);
    heading_->setTextFormat(Qt::RichText);
    column->addWidget(heading_);
    text_ = new QTextBrowser(this);
    text_->setObjectName(QStringLiteral("lesson-text"));
    text_->setAccessibleName(tr("Text of the lesson"));
    text_->setOpenLinks(false);
    text_->setFrameShape(QFrame::NoFrame);
    text_->setMinimumSize(120, 60);
    column->addWidget(text_, 1);
    connect(text_, &QTextBrowser::anchorClicked, this, &LessonPane::linkClicked);
    number_ = new QLineEdit(this);
    number_->setObjectName(QStringLiteral("lesson-number"));
    number_->setPlaceholderText(tr("Your number, then Enter"));
    number_->setAccessibleName(tr("Your number"));
    column->addWidget(number_);
    connect(number_, &QLineEdit::returnPressed, this, [this] {
        bool valid = false;
        // A decimal comma is understood as well.
        const double guess = QString(number_->text()).replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&valid);
        if (!valid) return;
        player_->guessNumber(guess);
        player_->reveal();
    });
    knobRow_ = new QWidget(this);
    auto* const knob = new QHBoxLayout(knobRow_);
    knob->setContentsMargins(0, 0, 0, 0);
    knob_ = new QSlider(Qt::Horizontal, knobRow_);
    knob_->setObjectName(QStringLiteral("lesson-knob"));
    knob_->setAccessibleName(tr("Knob of the lesson"));
    knob_->setPageStep(1);
    knobValue_ = new QLabel(knobRow_);
    knob->addWidget(knob_, 1);
    knob->addWidget(knobValue_);
    column->addWidget(knobRow_);
    connect(knob_, &QSlider::valueChanged, player_, &LessonPlayer::turnTo);
    auto* const row = new QHBoxLayout;
    back_ = button(this, QStringLiteral("◀"), tr("Previous page"), "lesson-previous");
    all_ = button(this, tr("Contents"), tr("Contents of the course"), "lesson-contents");
    forward_ = button(this, QStringLiteral("▶"), tr("Next page"), "lesson-next");
    place_ = new QLabel(this);
    row->addWidget(back_);
    row->addWidget(all_);
    row->addStretch(1);
    row->addWidget(place_);
    row->addWidget(forward_);
    column->addLayout(row);
    connect(back_, &QToolButton::clicked, player_, &LessonPlayer::previous);
    connect(forward_, &QToolButton::clicked, player_, &LessonPlayer::next);
    connect(all_, &QToolButton::clicked, this, [this] { contents_ ? pageCame() : showContents(); });
    connect(player_, &LessonPlayer::changedPage, this, &LessonPane::pageCame);
    connect(player_, &LessonPlayer::changedState, this, &LessonPane::refresh);
    connect(workspace_, &Workspace::scenarioChanged, this, &LessonPane::refresh);
    connect(workspace_, &Workspace::styleChanged, this, &LessonPane::refresh);
    applyType();
    refresh();
}

void LessonPane::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange && text_ != nullptr) applyType();
}

void LessonPane::applyType() {
    QFont type = font();
    if (lecture_) type.setPointSizeF(type.pointSizeF() * kLectureType);
    if (text_->font() != type) text_->setFont(type);
}

void LessonPane::setLecture(bool on) {
    lecture_ = on;
    applyType();
    refresh();
}

void LessonPane::showContents() {
    contents_ = true;
    refresh();
    text_->verticalScrollBar()->setValue(0);
}

void LessonPane::pageCame() {
    contents_ = false;
    number_->clear();
    refresh();
    text_->verticalScrollBar()->setValue(0);
}

QString LessonPane::plainText() const {
    return text_->toPlainText();
}

void LessonPane::linkClicked(const QUrl& link) {
    const QString what = link.scheme();
    const QString value = link.path();
    if (what == QLatin1String("choose")) {
        const auto choice = static_cast<std::size_t>(value.toInt());
        lecture_ ? player_->vote(choice) : player_->choose(choice);
    } else if (what == QLatin1String("answer")) {
        player_->reveal();
    } else if (what == QLatin1String("hint")) {
        player_->hint();
    } else if (what == QLatin1String("restore")) {
        player_->restore();
    } else if (what == QLatin1String("notes")) {
        Q_EMIT notesRequested();
    } else if (what == QLatin1String("open")) {
        const std::string folder = (std::filesystem::path(player_->course().folder) / value.toStdString()).string();
        player_->open(QString::fromStdString(folder));
    }
}

void LessonPane::refresh() {
    const bool open = player_->isOpen();
    const bool page = open && !contents_;
    back_->setEnabled(page && player_->before().has_value());
    forward_->setEnabled(page && player_->after().has_value());
    all_->setEnabled(open);
    all_->setText(contents_ ? tr("Back") : tr("Contents"));
    const bool knob = page && player_->page().knob.has_value();
    knobRow_->setVisible(knob);
    if (knob) {
        const QSignalBlocker quiet(knob_);
        const auto& values = player_->page().knob->values;
        knob_->setRange(0, static_cast<int>(values.size()) - 1);
        const int turn = player_->turn();
        if (turn >= 0) knobAt_ = turn;
        knob_->setValue(knobAt_);
        const relief::Json& value = values[static_cast<std::size_t>(std::max(turn, 0))];
        knobValue_->setText(turn < 0 ? QStringLiteral("–") : QString::fromStdString(relief::knobValueText(value)));
    }
    number_->setVisible(page && player_->page().question && player_->page().question->number && !player_->revealed() &&
                        !lecture_);
    if (!open) {
        heading_->clear();
        place_->clear();
        text_->setHtml(tr("No lesson is open. The menu “Lessons” has them."));
        return;
    }
    heading_->setText(
        QStringLiteral("<b>%1 · %2</b>").arg(plain(player_->lesson().name), inLine(*player_, player_->text().title)));
    place_->setText(tr("page %1 of %2").arg(player_->pageNumber() + 1).arg(player_->lesson().pages.size()));
    const int at = text_->verticalScrollBar()->value();
    text_->setHtml(contents_ ? contentsHtml() : pageHtml());
    text_->verticalScrollBar()->setValue(at);
}

QString LessonPane::contentsHtml() const {
    QString html;
    const relief::Language language = workspace_->style().language;
    for (const relief::Chapter& chapter : player_->course().chapters) {
        if (!chapter.title(language).empty()) html += QStringLiteral("<h4>%1</h4>").arg(plain(chapter.title(language)));
        for (const std::string& name : chapter.lessons) {
            const QString lesson = QString::fromStdString(name);
            const std::string folder = (std::filesystem::path(player_->course().folder) / name).string();
            const QString title = lessonTitle(QString::fromStdString(folder), language).toHtmlEscaped();
            const bool seen = player_->seenLesson(lesson);
            html += QStringLiteral("<p>%1 %2</p>")
                        .arg(seen ? QStringLiteral("✓") : QStringLiteral("&nbsp;&nbsp;"),
                             link(QStringLiteral("open:") + lesson,
                                  lesson.toHtmlEscaped() + QStringLiteral(" · ") + title));
        }
    }
    return html;
}

QString LessonPane::questionHtml() const {
    const auto& question = player_->page().question;
    if (!question) return {};
    const relief::PageText& words = player_->words();
    QString html = QStringLiteral("<hr><p><b>%1</b> %2</p>").arg(tr("Question."), inLine(*player_, words.question));
    int votes = 0;
    for (const int vote : player_->votes()) votes += vote;
    for (std::size_t n = 0; n < words.choices.size(); ++n) {
        QString mark = QStringLiteral("○");
        if (player_->chosen() == n) mark = QStringLiteral("●");
        if (player_->revealed() && player_->right()) mark = player_->right() == n ? QStringLiteral("✓") : mark;
        QString text = inLine(*player_, words.choices[n]);
        if (player_->revealed() && player_->right() == n) text = QStringLiteral("<b>%1</b>").arg(text);
        if (!player_->revealed()) text = link(QStringLiteral("choose:%1").arg(n), text);
        if (lecture_) {
            text = QStringLiteral("%1. %2").arg(n + 1).arg(text);
            if (votes > 0) text += QStringLiteral(" – <b>%1</b>").arg(player_->votes()[n]);
        }
        html += QStringLiteral("<p>%1 %2</p>").arg(mark, text);
    }
    return html + answerHtml();
}

QString LessonPane::answerHtml() const {
    const auto& question = player_->page().question;
    const relief::PageText& words = player_->words();
    if (!player_->revealed()) {
        QStringList ways;
        if (!words.hint.empty() && !player_->hinted()) ways << link(QStringLiteral("hint:"), tr("Hint"));
        ways << link(QStringLiteral("answer:"), tr("Answer"));
        return QStringLiteral("<p>%1</p>").arg(ways.join(QStringLiteral(" · ")));
    }
    QString html;
    if (player_->chosen() || player_->guessed()) {
        html += QStringLiteral("<p><b>%1</b></p>").arg(player_->guessIsRight() ? tr("Right.") : tr("Not so."));
    }
    if (question->number && player_->number()) {
        html += QStringLiteral("<p>%1</p>")
                    .arg(tr("It is %1.").arg(QString::fromStdString(relief::expressionValueText(*player_->number()))));
    }
    if (question->kind == relief::LessonQuestion::Kind::Choose && !player_->right() && !player_->measuring()) {
        html += QStringLiteral("<p>%1</p>")
                    .arg(tr("The scene was changed, so that none of the answers is the only right one."));
    }
    return html + player_->html(words.answer);
}

QString LessonPane::knobHtml() const {
    const auto& knob = player_->page().knob;
    if (!knob) return {};
    QString html = QStringLiteral("<hr>") + player_->html(player_->words().knob);
    if (player_->turns().empty()) return html;
    html += QStringLiteral("<table cellpadding=\"3\"><tr><td></td>");
    for (const auto& [turn, values] : player_->turns()) {
        const relief::Json& value = knob->values[static_cast<std::size_t>(turn)];
        html += QStringLiteral("<td align=\"right\"><b>%1</b></td>").arg(plain(relief::knobValueText(value)));
    }
    html += QStringLiteral("</tr>");
    for (std::size_t n = 0; n < knob->watch.size(); ++n) {
        html += QStringLiteral("<tr><td><code>%1</code></td>").arg(plain(knob->watch[n].value.text()));
        for (const auto& [turn, values] : player_->turns()) {
            html += QStringLiteral("<td align=\"right\">%1</td>")
                        .arg(QString::fromStdString(relief::expressionValueText(values[n])));
        }
        html += QStringLiteral("</tr>");
    }
    return html + QStringLiteral("</table>");
}

QString LessonPane::pageHtml() const {
    const relief::PageText& words = player_->words();
    QString html = QStringLiteral("<h3>%1</h3>").arg(inLine(*player_, words.title));
    if (player_->changed()) {
        html += small(tr("You changed the scene: the numbers are those of what you see.") + QLatin1Char(' ') +
                      link(QStringLiteral("restore:"), tr("Back to the page’s scene")));
    }
    html += player_->html(words.text) + questionHtml();
    if (!words.hint.empty() && player_->hinted())
        html += QStringLiteral("<p><i>%1</i></p>").arg(inLine(*player_, words.hint));
    if (!player_->page().question && !words.hint.empty() && !player_->hinted()) {
        html += QStringLiteral("<p>%1</p>").arg(link(QStringLiteral("hint:"), tr("Hint")));
    }
    html += knobHtml();
    if (!player_->problem().isEmpty()) html += small(player_->problem().toHtmlEscaped());
    if (player_->pageNumber() + 1 == player_->lesson().pages.size() && !player_->text().remember.empty()) {
        html +=
            QStringLiteral("<hr><p><b>%1</b> %2</p>").arg(tr("Remember."), inLine(*player_, player_->text().remember));
        if (!player_->text().source.empty()) html += small(inLine(*player_, player_->text().source));
    }
    if (!lecture_) html += small(link(QStringLiteral("notes:"), tr("Notes for the lecturer")));
    return html;
}

QString lessonNotesHtml(const LessonPlayer& player) {
    if (!player.isOpen()) return {};
    QString html =
        QStringLiteral("<h3>%1 · %2</h3>").arg(plain(player.lesson().name), inLine(player, player.words().title));
    html += player.html(player.words().note);
    if (player.page().question)
        html +=
            QStringLiteral("<p><b>%1</b></p>").arg(LessonPane::tr("The answer:")) + player.html(player.words().answer);
    if (player.lesson().minutes > 0) {
        html += QStringLiteral("<p>%1</p>")
                    .arg(LessonPane::tr("The lesson takes %1 minutes.").arg(player.lesson().minutes));
    }
    html += player.html(player.text().note);
    if (player.pageNumber() + 1 < player.lesson().pages.size()) {
        const auto& following = player.text().pages[player.pageNumber() + 1];
        html += QStringLiteral("<p>%1</p>").arg(LessonPane::tr("Next: %1").arg(inLine(player, following.title)));
    }
    return html;
}

}  // namespace reliefui
