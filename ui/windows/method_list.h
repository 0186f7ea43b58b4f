// The list of methods: each by its name in words, with its source; beside it, small, how commands and files spell it.
#pragma once

class QComboBox;

namespace reliefui {

// Fills the list; the data of an entry is the identifier. First those that search for the relief, then, under a
// heading, the others.
void fillMethods(QComboBox* list);

}  // namespace reliefui
