(cl:in-package gazebo_msgs-srv)
(cl:export '(MODEL_NAME-VAL
          MODEL_NAME
          PARENT_MODEL_NAME-VAL
          PARENT_MODEL_NAME
          CANONICAL_BODY_NAME-VAL
          CANONICAL_BODY_NAME
          BODY_NAMES-VAL
          BODY_NAMES
          GEOM_NAMES-VAL
          GEOM_NAMES
          JOINT_NAMES-VAL
          JOINT_NAMES
          CHILD_MODEL_NAMES-VAL
          CHILD_MODEL_NAMES
          IS_STATIC-VAL
          IS_STATIC
          SUCCESS-VAL
          SUCCESS
          STATUS_MESSAGE-VAL
          STATUS_MESSAGE
))