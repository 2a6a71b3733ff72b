set(quad_control_MESSAGE_FILES "")
set(quad_control_SERVICE_FILES "/work/wt/unity/src/quad_control/srv/Advance.srv;/work/wt/unity/src/quad_control/srv/Begin.srv;/work/wt/unity/src/quad_control/srv/FlightRecord.srv;/work/wt/unity/src/quad_control/srv/SetFlightPlan.srv;/work/wt/unity/src/quad_control/srv/TimingReport.srv")
