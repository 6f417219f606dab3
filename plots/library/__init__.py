"""What figures and pages share: style, records, the skeleton of a page."""
