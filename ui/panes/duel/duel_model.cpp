#include "panes/duel/duel_model.h"

#include <QBrush>
#include <QColor>
#include <QFont>

#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

constexpr int kDecimals = 4;

}  // namespace

void DuelModel::show(std::shared_ptr<const Duel> duel, const Style& style) {
    beginResetModel();
    duel_ = std::move(duel);
    style_ = style;
    endResetModel();
}

int DuelModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !duel_ ? 0 : static_cast<int>(duel_->steps.moments.size());
}

int DuelModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() || !duel_ ? 0 : static_cast<int>(duel_->runs.size());
}

bool DuelModel::moves(int row, std::size_t run) const {
    const auto& moments = duel_->steps.moments;
    const auto m = static_cast<std::size_t>(row);
    return m == 0 || moments[m][run] != moments[m - 1][run];
}

QString DuelModel::cell(int row, std::size_t run) const {
    const auto& steps = duel_->runs[run].steps;
    const std::size_t k = duel_->steps.moments[static_cast<std::size_t>(row)][run];
    if (k >= steps.size() || !moves(row, run)) return {};
    const relief::Step& step = steps[k];
    const auto number = [](double value) { return QString::fromStdString(relief::fixedText(value, kDecimals)); };
    const QString decision =
        QString::fromStdString(relief::sentence(relief::decisionTitle(step.decision), style_.language));
    return QStringLiteral("%1 %2 %3").arg(k + 1).arg(decision, number(step.lambdaAfter));
}

QVariant DuelModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const auto run = static_cast<std::size_t>(index.column());
    if (role == Qt::DisplayRole) return cell(index.row(), run);
    const relief::Judgement& fault = duel_->judgements[run];
    const std::size_t k = duel_->steps.moments[static_cast<std::size_t>(index.row())][run];
    const bool here = fault.kind != relief::Departure::None && k == fault.step && moves(index.row(), run);
    if (!here) return {};
    if (role == Qt::FontRole) {
        QFont font;
        font.setBold(true);
        return font;
    }
    const Rgba color = style_.color(Role::Overshoot);
    if (role == Qt::BackgroundRole) return QBrush(QColor(color.r, color.g, color.b, 70));
    if (role == Qt::ToolTipRole) {
        return QString::fromStdString(relief::sentence(relief::departureTitle(fault), style_.language));
    }
    return {};
}

QVariant DuelModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || !duel_) return {};
    if (role == Qt::ToolTipRole) return tr("number of the step, decision, λ after it");
    if (role != Qt::DisplayRole) return {};
    return QString::fromStdString(duel_->runs[static_cast<std::size_t>(section)].name);
}

}  // namespace reliefui
