set(quad_sim_MESSAGE_FILES "")
set(quad_sim_SERVICE_FILES "/work/wt/unity/src/quad_sim/srv/CommandReport.srv;/work/wt/unity/src/quad_sim/srv/RestoreState.srv;/work/wt/unity/src/quad_sim/srv/SaveState.srv;/work/wt/unity/src/quad_sim/srv/Step.srv")
