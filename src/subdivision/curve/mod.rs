//! Subdivision of polygons: corner cutting (Chaikin), the cubic scheme, and uniform B-splines of any degree (Lane and Riesenfeld).
//!
//! *In the course*: slides 51 to 63 (*algorithme de Chaikin*).
//!
//! *In the book*: [Curves](../../../../subdivision/curves.html).
