(cl:in-package gazebo_msgs-msg)
(cl:export '(AUTO_DISABLE_BODIES-VAL
          AUTO_DISABLE_BODIES
          SOR_PGS_PRECON_ITERS-VAL
          SOR_PGS_PRECON_ITERS
          SOR_PGS_ITERS-VAL
          SOR_PGS_ITERS
          SOR_PGS_W-VAL
          SOR_PGS_W
          SOR_PGS_RMS_ERROR_TOL-VAL
          SOR_PGS_RMS_ERROR_TOL
          CONTACT_SURFACE_LAYER-VAL
          CONTACT_SURFACE_LAYER
          CONTACT_MAX_CORRECTING_VEL-VAL
          CONTACT_MAX_CORRECTING_VEL
          CFM-VAL
          CFM
          ERP-VAL
          ERP
          MAX_CONTACTS-VAL
          MAX_CONTACTS
))