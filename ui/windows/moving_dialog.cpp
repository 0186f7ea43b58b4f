#include "windows/moving_dialog.h"

#include <optional>

#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QSpinBox>

#include "panes/file_dialogs.h"
#include "scenario/sequence.h"
#include "windows/html_page.h"
#include "windows/pane_list.h"
#include "windows/share.h"
#include "workspace/language.h"
#include "workspace/workspace.h"

namespace reliefui {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(reliefui::MovingPicture)
};

// What the dialog returns.
struct Wanted {
    FigureKind kind;
    QString sequence;           // as on the command line
    std::optional<int> frames;  // where the number is not given by the sequence
    bool page = true;
};

// Fills the list of what can move; an item's data are the sequence, or "sweep:OPTION=" and then the proposed values.
void fillMoves(QComboBox& moves, const relief::Scenario& scenario, bool steps) {
    moves.clear();
    if (steps) moves.addItem(Texts::tr("the steps of the ray"), QStringList(QStringLiteral("steps")));
    if (scenario.camera.kind == relief::Camera::Kind::Orbit)
        moves.addItem(Texts::tr("the camera, around its target"), QStringList(QStringLiteral("orbit")));
    for (const relief::SweptOption& option : relief::sweptOptions(scenario)) {
        const QString name = QString::fromStdString(option.name);
        moves.addItem(name, QStringList{QStringLiteral("sweep:%1=").arg(name), QString::fromStdString(option.values)});
        moves.setItemData(moves.count() - 1, QString::fromStdString(option.help), Qt::ToolTipRole);
    }
}

std::optional<Wanted> askWanted(QWidget* window, Workspace* workspace, const QString& pane) {
    std::vector<FigureKind> kinds;
    QDialog dialog(window);
    dialog.setObjectName(QStringLiteral("moving-picture"));
    dialog.setWindowTitle(Texts::tr("Moving picture"));
    auto* const form = new QFormLayout(&dialog);
    auto* const panes = new QComboBox(&dialog);
    panes->setObjectName(QStringLiteral("moving-pane"));
    for (const PaneKind& one : paneList()) {
        if (one.figures.empty() || !one.figures.front().make) continue;
        kinds.push_back(one.figures.front());
        panes->addItem(one.title);
        if (one.name == pane) panes->setCurrentIndex(panes->count() - 1);
    }
    form->addRow(Texts::tr("Pane:"), panes);
    auto* const moves = new QComboBox(&dialog);
    moves->setObjectName(QStringLiteral("moving-what"));
    form->addRow(Texts::tr("What changes:"), moves);
    auto* const values = new QLineEdit(&dialog);
    values->setObjectName(QStringLiteral("moving-values"));
    values->setToolTip(Texts::tr("FROM..TO, or values with commas between them"));
    form->addRow(Texts::tr("Values:"), values);
    auto* const frames = new QSpinBox(&dialog);
    frames->setObjectName(QStringLiteral("moving-frames"));
    frames->setRange(2, relief::kMostSequenceFrames);
    frames->setValue(relief::kSequenceFrames);
    form->addRow(Texts::tr("Frames:"), frames);
    auto* const written = new QComboBox(&dialog);
    written->setObjectName(QStringLiteral("moving-written"));
    written->addItem(Texts::tr("one page for browsers"));
    written->addItem(Texts::tr("numbered pictures (PNG)"));
    form->addRow(Texts::tr("Written as:"), written);
    const auto follow = [=] {
        const QStringList data = moves->currentData().toStringList();
        values->setEnabled(data.size() > 1);
        values->setText(data.value(1));
    };
    const auto count = [=] {
        const bool steps = moves->currentData().toStringList().value(0) == QLatin1String("steps");
        frames->setEnabled(!steps && (!values->isEnabled() || values->text().contains(QStringLiteral(".."))));
    };
    QObject::connect(moves, qOverload<int>(&QComboBox::currentIndexChanged), &dialog, follow);
    QObject::connect(moves, qOverload<int>(&QComboBox::currentIndexChanged), &dialog, count);
    QObject::connect(values, &QLineEdit::textChanged, &dialog, count);
    const auto fill = [=, &kinds] {
        const auto kind = static_cast<std::size_t>(panes->currentIndex());
        fillMoves(*moves, workspace->scenario(), followsSteps(kinds[kind]));
    };
    QObject::connect(panes, qOverload<int>(&QComboBox::currentIndexChanged), &dialog, fill);
    fill();
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    form->addRow(buttons);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    Wanted wanted;
    wanted.kind = kinds[static_cast<std::size_t>(panes->currentIndex())];
    wanted.sequence = moves->currentData().toStringList().value(0) + (values->isEnabled() ? values->text() : QString());
    if (frames->isEnabled()) wanted.frames = frames->value();
    wanted.page = written->currentIndex() == 0;
    return wanted;
}

}  // namespace

void askMovingPicture(QWidget* window, Workspace* workspace, const QString& pane) {
    const auto wanted = askWanted(window, workspace, pane);
    if (!wanted) return;
    try {
        const auto sequence = relief::parseSequence(wanted->sequence.toStdString(), wanted->frames, "--sequence");
        if (sequence.kind != relief::Sequence::Kind::Steps) framesOf(sequence, workspace->scenario(), sequence.option);
    } catch (const relief::InputError& error) {
        return Q_EMIT workspace->problem(QString::fromStdString(error.text(uiLanguage())));
    }
    const QString name = QString::fromStdString(wanted->kind.name);
    const QString file = wanted->page ? askPageFile(window, name)
                                      : askSaveFile(window, QStringLiteral("frames"), Texts::tr("Moving picture"),
                                                    name + QStringLiteral(".png"), Texts::tr("Pictures (*.png)"));
    if (file.isEmpty()) return;
    QStringList how{QStringLiteral("--sequence"), wanted->sequence};
    if (wanted->frames) how << QStringLiteral("--frames") << QString::number(*wanted->frames);
    if (wanted->page) how << QStringLiteral("--html");
    writePane(workspace, name, how, file);
}

}  // namespace reliefui
