// SPDX-License-Identifier: MIT
// Every panel. They are listed, not registered by themselves: a linker drops what nobody names.
#include "ui/panels/panel.h"

namespace svoscope::ui {

extern const Panel kImagePanel, kScenePanel, kSeedPanel, kEpipolarPanel, kDivergencePanel,
    kLabPanel, kPlotsPanel, kTimingPanel, kFunnelPanel, kSelectionPanel, kEvaluationPanel,
    kCompareImagesPanel, kCompareScenePanel, kCompareMetricsPanel, kComparePlotsPanel,
    kParametersPanel, kLogPanel, kHelpPanel;

const std::vector<const Panel*>& panels() {
  static const std::vector<const Panel*> list{&kImagePanel,        &kScenePanel,
                                              &kSeedPanel,         &kEpipolarPanel,
                                              &kDivergencePanel,   &kLabPanel,
                                              &kPlotsPanel,        &kTimingPanel,
                                              &kFunnelPanel,       &kSelectionPanel,
                                              &kEvaluationPanel,   &kCompareImagesPanel,
                                              &kCompareScenePanel, &kCompareMetricsPanel,
                                              &kComparePlotsPanel, &kParametersPanel,
                                              &kLogPanel,          &kHelpPanel};
  return list;
}

const Panel* findPanel(const std::string& name) {
  for (const Panel* panel : panels()) {
    if (name == panel->name) return panel;
  }
  return nullptr;
}

}  // namespace svoscope::ui
